### What is about no place in a scene, in English: files, settings, wishes on the command line.

## Words around and of others

quoted = { $text }
at-place = { $path }:{ $line }:{ $column }: { $why }
at-line = { $path }:{ $line }: { $why }

## Files

no-scene = { $path } is not a scene
no-picture = { $path } is not a picture
cannot-read = cannot read { $path }: { $reason }
cannot-write = cannot write { $path }: { $reason }
cannot-print = cannot write to standard output: { $reason }
not-found-but = there is no such file, but { $path }
too-large = it is larger than { $size } GiB
picture-broken = it is damaged, or in a form that zpg does not read
picture-too-wide = it has { $width } × { $height } pixels; { $side } × { $side } are read at most
pictures-too-large = the pictures of a scene may take at most 256 MiB together
cannot-write-in-place = cannot write { $path }: { $reason }; its old content is kept in { $copy }
no-folder = there is no folder { $path }
read-only-file = it is read-only
no-regular-file = it is not a regular file
wrong-ending = { $path } ends in { $ending }, but the output has another format: choose a name that ends in { $right }
scene-name = the name of a scene ends in .zpg: write { $right }
file-is-there = { $path } already exists: choose another name, or overwrite it with --force
scene-is-there = { $path } is a scene that already exists: choose another name, or overwrite it with --force
other-ending = { $path } has the ending of another tool's files ({ $ending }) and is left as it is; --force changes it anyway
text-lost = written as { $encoding }, it would lose characters
no-scene-any-more = too few of its lines would begin with a number, or too few of its numbers would be in records, so that zpg would no longer recognise it as a scene
layout-changes-content = internal error: formatting would change what { $path } says, so it is left as it is; please report this
no-scenes = no scene files (*.zpg) in { $path }

io-not-found = No such file or directory
io-denied = Permission denied
io-is-a-directory = Is a directory
io-not-a-directory = Not a directory
io-full = No space left on device
io-read-only = Read-only file system

## Settings

in-file = { $path }:{ $line }:{ $column }: { $why }
setting-toml = this is not TOML: { $reason }
setting-truth = { $text } is not a TOML value: write `true` or `false`
setting-quotes = { $text } is not a TOML value: a text needs quotes, write { $right }
setting-unknown = there is no setting { $key }, only { $known }
setting-codes-known = codes with their levels, as in `W310 = "off"`, and `per-file-ignores`
setting-value = `{ $key }`: expected { $wanted }, found { $found }
setting-glob = { $text } is not a file pattern: { $reason }
setting-table = a table
setting-level = one of `error`, `warning`, `note`, `off`
setting-codes = a list of codes, such as ["W307", "style"]
setting-patterns = a list of file patterns, such as ["old", "*/draft.zpg"]
setting-width = a whole number (a width is from 20 to 1000)
setting-bool = true or false
setting-numbers = "shortest" or "keep"
config-neither = --config: there is no file { $path }; a setting is written as in lint.W310=off
config-setting = --config { $text }: { $why }
config-two-files = --config names two settings files, { $first } and { $second }: name one
config-isolated = --config { $path } cannot be used with --isolated, which ignores all settings files

## Codes and topics

no-code-of = there is no code { $text }
no-code = there is no code { $text } (`zpg explain` lists all)
always-error = { $code } is always an error
error-not-ignored = { $code } is always an error and cannot be ignored
statistics-format = statistics are text or JSON: --format human or json
no-topic = there is no finding or record type { $text }
no-topic-list = there is no finding or record type { $text } (`zpg explain` lists all)

## Watching

stdin-not-watched = standard input cannot be watched
watch-no-width = `-w` watches the scene and takes no { $text }: write a size as in `--size 64x48`
cannot-watch = cannot watch for changes: { $reason }
watching = Watching for changes; Ctrl-C ends it

## Formatting

would-reformat = would reformat: { $path }
would-be-reformatted = { $count ->
    [one] { $count } file
   *[other] { $count } files
} would be reformatted
reformatted = { $count ->
    [one] { $count } file
   *[other] { $count } files
} reformatted
left-unchanged = { $count ->
    [one] { $count } file
   *[other] { $count } files
} left unchanged
list-comma = { $first }, { $last }
range-behind-end = { $path } has { $lines ->
    [one] { $lines } line
   *[other] { $lines } lines
}: nothing is formatted
layout-mistake = { $place }: { $code }: { $message }; lines with mistakes stay as they are, `{ $command }` says more
layout-mistake-stdin = { $place }: { $code }: { $message }; lines with mistakes stay as they are
range-of-many = --range works on one file only
not-a-file = it is not a plain file
stdin-and-path = `--stdin-filename` names standard input, so { $path } is not read: leave out one of them
misnamed-settings = { $path } is ignored: a settings file must be named { $right }
no-files = there is no scene file to show the settings of

## Drawing and asking

cannot-draw = { $what } cannot be drawn (object { $id })
draw-nothing = there is nothing to draw: the scene has no render record
draw-no-picture = an image texture without its picture
draw-matrix = a transformation whose inverse is out of range
draw-projection = what a camera with this projection sees
crop-too-large = --crop reaches beyond the picture of { $width }x{ $height } pixels
too-many-pixels = a picture has at most { $max } pixels
picture-needs-memory = the picture would take { $needed } of memory, and --memory { $memory } is allowed: choose a smaller --size or --crop
file-needs-memory = it is so long that about { $needed } of memory would be needed, and --memory { $memory } is allowed
too-many-parts-in-one-place = the scene has { $parts } parts, each occurrence counted, and so many of them lie over one another that rays would need more than --memory { $memory } allows: let fewer copies overlap, or allow more
expected-memory = expected an amount of memory, such as 800M or 12G
fewer-threads = --threads { $wanted } is too many; { $most } threads are started, four for each processor
no-threads = cannot start threads: { $reason }
ctrl-c-leaves = Ctrl-C may leave temporary files: { $reason }
ctrl-c-leaves-programs = Ctrl-C may leave other programs running: { $reason }
heatmap-scale = heatmap: intersection tests per pixel, from 0 (black) to { $max } (light yellow), on the scale log(1 + n)
unknown-format = cannot tell the format of { $path }: expected a name that ends in .png, .jpg, .webp, .exr or .pfm
unseen-outside = outside of the box of the render record
unseen-inside = inside of the opaque { $type } { $id }
map-is-png = a heatmap is a PNG picture: expected a name that ends in .png, not { $path }

no-such-camera = the scene has no camera { $id }; its cameras: { $cameras }
no-cameras = the scene has no camera { $id }: it has no cameras at all
stereo-of-one = --stereo needs two cameras, and the picture is taken by one: the scene has no stereo camera (type -503), or --camera chooses one
two-on-stdout = standard output takes one of the outputs: name a file for the other
pair-on-stdout = two pictures cannot be written to standard output: choose --stereo side-by-side or --stereo anaglyph
note-left-eye = camera { $id }, the left one of the two, takes the picture; `--camera` chooses the other
note-no-camera = the scene has no camera: it is seen from the right, the front and above
note-comma = line { $line }: { $text } is read as two numbers, { $number }; write a decimal point if it is one{ $more ->
    [0] { "" }
   *[other] {" "}({ $more } more like it)
}
note-undrawn = { $count ->
    [one] { $count } object is
   *[other] { $count } objects are
} not drawn: `zpg check` says which
note-no-light = the scene has no light: an ambient light and a lamp above the camera and to its left are added
note-nothing-in-view = nothing is in view; `--view iso` shows the whole scene
note-nothing-to-see = the scene has nothing that could be seen; `zpg check` says why
note-camera-inside = the camera is inside of a solid: the picture shows that from within
note-nothing-lit = no light falls on anything that is seen
note-too-bright-by = { $percent } % of the pixels are brighter than white: the record { $id } gives out more light than it gets; `zpg check` says what to write
note-too-bright = { $percent } % of the pixels are brighter than white; `--exposure { $exposure }` corrects it
note-drawn-anyway = { $path } does not record which picture it holds, as .png and .exr do: it is drawn in any case
note-unfinished = { $path } keeps { $percent } % of the picture; the same command with `--resume` draws the rest
note-other-part = { $path } is a part of another picture: nothing of it is used
note-earlier-job = { $path } holds an earlier job, which this one replaces: scripts and scenes are written anew; pictures stay, and those that would come out the same are not drawn again
note-one-frame = `--frames { $frame }` draws frame { $frame } alone; the first { $frame } are `--frames 0-{ $last }`
several-with-one-output = `--stats` and `--heatmap` are for one scene
several-with-tile = `--tile` is for one scene
part-format = { $path } cannot record which part of a picture it holds: choose a name that ends in .png or .exr
more-tiles-than-rows = more tiles ({ $count }) than the picture has rows ({ $height })
already-drawn = { $path } is drawn already
too-large-for-format = pictures like { $path } are at most { $most } pixels wide and high
several-on-stdout = standard output takes one picture: name a folder with `-o`
several-in-one-file = { $path } is one file, and these are several scenes: name a folder with `-o`
wrote-file = Wrote { $path }
wrote-scene = Wrote { $path }; `zpg render { $file }` draws it
picture-not-translated = { $path } is a picture: `zpg render { $scene } -o { $path }` draws it
no-target = which format? Name it with `--to` ({ $names }), or let the name after `-o` end in .pov, .xml, .ply, .obj, .glb, .stl, .json or .zpg
gltf-is-glb = zpg writes glTF as one binary file: name it with `-o { $path }`
wrote-picture = Wrote { $path }: { $width } × { $height } pixels
wrote-joined = { $wrote }; removed { $count ->
    [one] its part
   *[other] its { $count } parts
}
wrote-rows = Wrote { $path }: rows { $first } to { $last } of { $height }
farm-folder = { $path } has other things in it: name a folder that is new or empty, or an earlier job
farm-name = { $path } cannot go into a job: its name has a line break in it, or is not UTF-8
farm-same-name = two scenes are named { $name }, and their pictures would have the same name: rename one of them
farm-stdin = a job needs scenes that are files
too-many-tasks = there are too many tasks: more than 4294967295
expected-number-from-one = expected a whole number from 1 to 1000000
not-drawn-by-zpg = { $path } does not say what picture it is a part of: it was not written by `zpg render`, or another program has changed it
picture-cut-off = { $path } is damaged or cut off: draw it again
joined-format = a picture is joined as .png or .exr, not as { $path }
joined-whole = { $path } is a whole picture, not a part of one
joined-unfinished = { $path } is what an interrupted `zpg render` has left: `zpg render --resume` goes on with it
exr-of-png = an .exr cannot be made from { $path }, which has 8-bit colours: draw the parts as .exr
no-parts = there are no parts: no file that ends in .png or .exr
parts-left-out = left out: { $paths }; a part is a PNG or EXR file with another name than the picture
part-changed = { $path } was changed while the parts were joined
part-of-another = { $path } is a part of another picture than { $other }: { $reason }
of-another-version = it was drawn by another version of zpg
of-another-scene = it was drawn from another scene, or with another texture
of-other-options = it was drawn with other options
rows-twice = rows { $first } to { $last } are in { $path } and in { $other }
rows-missing = { $count ->
    [one] one row of { $height } is missing: { $rows }
   *[other] { $count } rows of { $height } are missing: { $rows }
}

# Frames: scenes of which some numbers vary.

no-frames = { $arg } needs `--frames`, which says which frames there are, as in --frames 0-99
frames-alike = all frames would be alike: `--set`, `--orbit` or `--frames-from` says what varies
frames-on-stdout = frames are several pictures: name a file with `-o`, such as film.png or film.apng
frames-of-json = { $path } is a scene in JSON, and only numbers of records can vary: `zpg convert --to zpg` makes records of it
only-outside = `--only` names frames that are not among the frames { $frames }
too-many-frames = there are at most { $most } frames
film-of-one = zpg does not write { $path }; `-o { $still }` makes a still picture, and with `--frames` and `-o { $animated }` zpg writes an animated one
film-by-ffmpeg = zpg does not write { $path }: draw the frames with `-o { $frames }`, and make a film of them with `{ $line }`. With `-o { $animated }` zpg itself writes an animated picture
animation-without-frames = { $path } is an animated picture: `--frames` says of which frames
animation-of-tiles = `--tile` draws parts of frames into .png or .exr files, not into { $path }
fps-of-files = `--fps` is for an animated picture (.apng), and { $path } is not one
note-camera-stays = camera { $id } takes the picture and stays where it is, since `--orbit` turns another one; the ID of a stereo camera (type -503) turns both of its cameras
wrote-animation = Wrote { $path }: { $frames ->
    [one] { $frames } frame
   *[other] { $frames } frames
} of { $width } × { $height } pixels
in-frame = frame { $frame }: { $why }
frame-has-errors = there are errors in the scene of frame { $frame }
frame-reads-otherwise = with these numbers the text reads as other records: put line breaks between the records
in-set = --set: { $why }
in-orbit = --orbit: { $why }
in-cell = { $path }, row { $row }, column { $column }: { $why }
empty-table = { $path } has no rows of numbers: it needs one for each frame, below the row with the names
empty-cell = the cell is empty
cell-beyond = the first row has no name for the column of `{ $text }`
rows-and-frames = `--frames` names { $frames ->
    [one] { $frames } frame
   *[other] { $frames } frames
}, and the table has { $rows ->
    [one] { $rows } row
   *[other] { $rows } rows
} of numbers
set-twice = { $name } is varied twice
no-record-of-id = the scene has no record with ID { $id }
no-record-on-line = { $name }: no record with this ID begins on this line; such records begin on lines { $lines }
no-such-parameter = { $name }: the records with ID { $id } have no number of this name; they have: { $known }
no-parameters = the records with ID { $id } have no numbers that could vary
parameter-left-out = { $name } is not written in the scene: write the optional numbers of the record first
several-parameters = { $name } may mean several: write one of { $names }
parameter-is-list = { $name }: the numbers of this list are { $first } to { $last }
parameter-no-list = { $name }: this is one number, not a list; leave out the brackets
parameter-is-whole = { $name } is a whole number or a name, which does not vary
orbit-of-moved = camera { $id } is moved by the record on line { $line }: write its position and direction into the camera's own record, and leave that record out
orbit-of-projection = camera { $id } has a projection matrix alone, and no position that could turn: write a camera record (type -501) before it
orbit-without-direction = the cameras of { $id } look into opposite directions, and have no axis in common

no-such-object = the scene has no object { $id }
no-such-object-of = the scene has no object { $id }; its objects: { $objects }
no-such-object-near = the scene has no object { $id }; did you mean { $near }?
not-an-object = { $id } is { $kind-a }, not an object
two-inputs = the scene and the rays cannot both be standard input
no-question = there is no question
not-a-pixel = pixel { $x },{ $y } is not in a picture of { $width }x{ $height } pixels
no-ray-in-pixel = the camera's projection has no ray in pixel { $x },{ $y }
ray-out-of-range = this ray is out of the range of this precision
hits-out-of-range = this ray meets the scene out of the range of this precision
too-many-occurrences = the point is in the bounds of too many occurrences of shared objects
no-inverse = a transformation has no inverse in double precision
line-unreadable = cannot be read: { $reason }
line-too-long = the line is longer than { $max } bytes
point-out-of-range = a transformation takes the point out of the range of double precision
number-out-of-range = { $word } is out of range
not-a-number = { $word } is not a number
decimal-commas = numbers have a decimal point: { $number }
wrong-count = expected { $expected ->
    [one] { $expected } number
   *[other] { $expected } numbers
}, found { $found }
zero-direction = the direction is the zero vector

## Comparing

no-program = { $program } is not installed: get it { $how } (`{ $path }` was tried)
no-such-program = there is no program { $path }
program-failed = { $program } has failed:
    { $said }
program-late = { $program } was ended, as it took longer than { $seconds } s: allow it more with `--timeout`, or choose { $instead }
crosscheck-late-povray = a smaller `--size` or `--depth`
crosscheck-late-mitsuba = a smaller `--size`
program-strange = { $program }: { $what }

## Translating

camera-nowhere = camera { $id } looks nowhere
camera-of-no-lens = the projection matrix of camera { $id } has no rays that POV-Ray could follow: they neither come from one point nor are they parallel
camera-of-no-squares = camera { $id } has pixels that are not squares at { $size }, and Mitsuba has no such camera: choose --size { $other }
camera-of-never-squares = camera { $id } has pixels that are not squares at { $size }, Mitsuba has no such camera, and no other --size helps
too-many-triangles = this takes at least { $needed } triangles, and at most { $most } are made: choose a larger --tolerance or a smaller part of the scene
too-many-to-count = the --tolerance is too small for the triangles to be counted, and at most { $most } are made: choose a larger one
too-many-joined = { $solids ->
    [one] { $solids } solid overlaps others
   *[other] { $solids } solids overlap each other
}, the shape { $shape } among them, and have too many triangles to be joined: choose a larger --tolerance or a smaller part of the scene
mesh-without-name = a scene from standard input has no name: say with -o where to write the { $format } file
would-overwrite-image = { $path } is a picture that the scene uses and would be overwritten: choose another name for what is written
sheet-format = cannot tell what the sheet is to be from the name { $path }: expected a name that ends in .png or .html
sheet-too-large = the sheet would be too large for a PNG: choose a smaller --size or another number of --columns
sheet-picture-too-large = it has { $width } × { $height } pixels; a sheet shows pictures of up to 134 million pixels
sheet-findings-broken = { $path } is not what `zpg check --format json` writes (line { $line }, column { $column }): write it anew, or remove it
sheet-findings-version = { $path } has version { $version }, which this zpg does not read: write it anew with `zpg check --format json`
no-pictures = no pictures (*.png, *.jpg, *.webp, *.exr, *.pfm) in { $path }
would-overwrite-picture = { $path } is a picture of the folder and would be overwritten: choose another name for the sheet
mesh-on-stdout = an OBJ consists of several files: name one with -o
binary-on-terminal = the output is binary and not for a terminal: name a file with -o, or redirect standard output to one
pictures-of-one-name = the pictures of { $scene } and { $other } would both be { $path }: draw them one by one, or name a folder that both are in
would-write-twice = { $path } would be written twice: choose another name for one of the files
would-overwrite-scene = { $path } is the scene itself and would be overwritten: choose another name for what is written
many-files = the translation is more than one file ({ $documents ->
    [one] { $documents } document
   *[other] { $documents } documents
}, { $meshes ->
    [one] { $meshes } mesh
   *[other] { $meshes } meshes
}): say with -o where to write it, as in -o scene.xml

## Scenes as JSON

json-deep = lists and objects are nested too deep
json-not-formatted = { $path } is a scene in JSON, which zpg fmt does not lay out
own-mistake = { $path }: zpg has made a mistake and has given up on this file; please report the mistake, with the file and the lines above
json-not-changed = { $path } is a scene in JSON, which zpg check only reads: --fix, --diff and --add-allow are for records
json-ends = this is not JSON: it ends too early, something is not closed
json-syntax = this is not JSON: { $what }
json-missing = `{ $field }` is missing: add it
json-twice = `{ $field }` is there twice: leave one of them out
json-no-field = there is no `{ $field }` here, only { $known }
json-no-kind = there is no kind `{ $kind }`, only { $known }
json-too-many = the list is too long
json-out-of-range = the number is too large
json-expected = expected { $wanted }, found { $found }
json-number = a number
json-whole-number = a whole number from 0 to 4294967295
json-string = a text in quotation marks
json-list = a list
json-list-of = a list of { $length }
json-shorter-list = a shorter list
json-object = an object in braces
json-version = version { $found } is not known, only version { $known }
json-not-before = it names node { $node }, which must stand before it
json-no-node = there is no node { $node }
json-no-camera = there is no camera { $camera }
json-id-range = an ID is from 2 to { $max }, not { $id }
json-id-taken = the ID { $id } is taken
json-colours = there must be a colour for each point of the profile, or none
json-normals = a triangle has no normal, one, or three
json-image-name = this cannot be the name of an image file

## Usage

usage = Usage: { $usage }
usage-more = For more information, try `--help`.
usage-unknown = unexpected argument `{ $arg }`
usage-no-command = there is no command `{ $arg }`
usage-missing = missing: { $arg }
usage-twice = `{ $arg }` can be given only once
usage-conflict = `{ $arg }` cannot be used with `{ $other }`
usage-no-value = `{ $arg }` needs a value
usage-flag = `{ $arg }` takes no value, but `{ $text }` is given
usage-value = `{ $text }` is not a value of `{ $arg }`
usage-not-text = an argument is not UTF-8 text
usage-values = there are { $values }

# What ruff has and zpg calls otherwise, or has not.

habit-add-allow = zpg calls it `zpg check --add-allow`
habit-analyze = `zpg plan` says which effects a scene needs
habit-angle = there is no such option; the angle of view is the last number of the camera's record (-501)
habit-all-codes = `zpg explain` without an argument lists all
habit-axes = `zpg accuracy` compares several values; `--axes` says of what, for example `--axes samples,adaptive`
habit-background = there is no such option; the background is the second number of the render record (9999): the ID of a colour, or 0 for black
habit-behind-command = the options of a command stand behind its name: `zpg check { $text }`
habit-cache = zpg keeps no cache
habit-called = zpg calls it `{ $text }`
habit-check = zpg calls it `zpg check`
habit-check-json = `zpg check` calls it `--format json`
habit-clock = there is no such option; a number of the scene that varies from frame to frame is named by `--set`, for example `--frames 0-29 --set 9.fovy=30..60`
habit-completions = zpg calls it `zpg completions`
habit-config = `zpg check --show-settings` shows all settings, and `--config` changes one
habit-convert = zpg calls it `zpg convert`
habit-crosscheck = zpg calls it `zpg crosscheck`
habit-declare = zpg has no such option: the numbers of a scene stand in its file
habit-default = that is the default: leave out `{ $text }`
habit-deny = zpg calls it `--deny warnings`
habit-dry-run = zpg calls it `--diff`
habit-exclude = zpg calls it `--exclude`, which counts in place of `exclude` in zpg.toml
habit-exit-non-zero = there is no such option; `--diff` writes nothing and exits with 1 where something would change
habit-exit-zero = zpg calls it `--exit-zero`
habit-extension = there is no such option; zpg knows a scene by what is in it
habit-fix = zpg calls it `zpg check --fix`
habit-fix-only = there is no such option; `zpg check --fix` fixes what it can and then reports what is left, and `--exit-zero` makes its exit status 0
habit-fixable = there is no such option; `--fix` fixes all that is certain, and `--select` and `--ignore` choose what is looked for
habit-fmt-output = there is no such option; `zpg fmt` writes into the files, and `zpg fmt - < scene.zpg` to standard output
habit-format = `zpg convert` calls it `--to`, or takes the ending of `-o`; `zpg check` calls it `--output-format`
habit-depth = zpg calls it `--depth`, for example `--depth 5`
habit-frames = zpg calls it `--frames`, for example `--frames 0-29 --set 9.fovy=30..60`
habit-from = zpg calls it `--from { $text }`
habit-gamma = there is no such option; pictures are written in sRGB, and `--exposure` makes them brighter
habit-gitignore = there is no such option; zpg always honours .gitignore in folders
habit-ignore = zpg calls it `--ignore`
habit-ignore-allow = there is no such option; the comments that allow findings always count
habit-in-place = there is no such option; `zpg fmt` writes into the files, and `--diff` only shows what it would change
habit-json = zpg calls it `--json`
habit-line-length = zpg calls it `--config format.width={ $length }`
habit-linter = `zpg explain` lists all codes
habit-new = zpg calls it `zpg new`
habit-no-fix = there is no such option; `zpg check` writes nothing without `--fix`
habit-no-option = that is the default, without any option
habit-none = zpg has no such option
habit-output = the file to write is named by `-o { $path }`
habit-output-format-explain = there is no such option; `zpg explain` writes Markdown where its output is not a terminal
habit-output-format-fmt = there is no such option; `--diff` shows what would change, and `--check` names the files
habit-per-file-ignores = zpg calls it {"`"}--config 'lint.per-file-ignores={"{"}"*" = ["W310"]{"}"}'`
habit-picture-format = the ending of `-o` says the format, for example `-o picture.png`
habit-preview = there is no such option; all rules of zpg are stable
habit-probe-json = there is no such option; `zpg probe` always writes JSON
habit-render = zpg calls it `zpg render`
habit-render-preview = there is no such option; `--quality draft` draws quickly, and `--watch` draws again when the scene changes
habit-samples = zpg calls it `--samples`, or `--quality draft`, `good` or `final`
habit-scene-named = the scene is named on its own, without `{ $text }`
habit-scene = the scene is named on its own, without an option: `zpg render { $path }`
habit-seed = there is no such option; the samples of a picture are always the same
habit-server = zpg calls it `zpg lsp`
habit-show-fixes = there is no such option; `--diff` shows what `--fix` would change
habit-show-source = there is no such option; findings always show their lines, and `--output-format concise` leaves them out
habit-silent = zpg calls it `--quiet`
habit-size-or-silent = zpg calls it `--size`, for example `--size 640x480`; for less output, use `--quiet`
habit-silent-or-size = zpg calls it `--quiet`; the size of a picture is `--size`, for example `--size 640x480`
habit-size = zpg calls it `--size`, for example `--size { $size }`
habit-target-version = there is no such option; the scene language has one version
habit-to = zpg calls it `--to`, for example `--to pov`
habit-translation = `zpg convert { $scene } -o { $path }` translates the scene
habit-threads = zpg calls it `--threads`, for example `--threads { $threads }`
habit-verbose-render = there is no such option; `--cost` prints what the picture has cost and where, and `zpg plan` which effects it needs
habit-verbose = there is no such option; zpg says all that it found
habit-version = zpg calls it `zpg --version`
habit-view = zpg calls it `--view { $text }`; `--camera` takes the ID of a camera

with-reason = { $what }: { $reason }
with-near = { $what }; did you mean { $near }?

expected-frames = expected frames as in 0-99, or one, such as 7
expected-set = expected ID.PARAM=FROM..TO, as in 9.fovy=30..60
expected-parameter = `{ $text }` names no number: expected a name such as 9.fovy, 5.x[3] or 5@7.x
expected-orbit = expected the ID of a camera and degrees, as in 9,360
expected-fps = expected a whole number from 1 to 1000
expected-size = expected WxH, as in 640x480
not-pixels = `{ $text }` is not a number of pixels
expected-crop = expected X,Y,W,H in pixels, as in 200,100,64,64
expected-tile = expected a band such as 3/8, or several such as 3-5/8, counted from 1
expected-pixel = expected X,Y in pixels, as in 320,240
expected-lines = lines are written as 3-9, or as 3
expected-length = expected a length above 0
expected-difference = expected a number above 0, up to 255
expected-columns = expected a whole number from 1 to 10000
expected-thumbnail = expected WxH from 32x32 to 1024x1024
expected-tolerance = expected a number above 0, up to 1
decimal-comma = write `{ $number }`, with a decimal point
expected-exposure = expected a number above 0, such as 0.5
expected-cutoff = expected a number from 0 to 1, such as 0.001 or 1/4096
expected-samples = expected a whole number from 1 to 1048576
expected-whole-number = expected a whole number from 0 to 4294967295
expected-time = expected a time such as 90s, 2m or 1h, up to a day
expected-runs = expected a number of runs from 1 to 100
expected-goal = expected a number of steps above 0, up to 255

## Editors

lsp-left-out = { $count ->
    [one] one more finding is left out
   *[other] { $count } more findings are left out
}
lsp-allow = Allow { $code } ({ $name }) here
lsp-explain = Explain { $code } ({ $name })
lsp-fix-all = Apply all safe fixes
lsp-renumber = Number all IDs anew, in the order of the file
lsp-comment-out = Comment out
lsp-comment-in = Comment in
lsp-new-scene = new scene
lsp-profile-point = point { $place }: { $name }
lsp-profile-colour = colour of point { $place }: { $name }
lsp-render = Render
lsp-preview = Preview
lsp-crosscheck = Check in POV-Ray
lsp-used = used { $count ->
    [one] once
   *[other] { $count } times
}
lsp-no-id = there is no ID here
lsp-render-id = 1 is the ID of the render record and stays so
lsp-reserved-id = 1 is kept for the render record
lsp-not-an-id = { $text } is not an ID: an ID is a whole number from 2 to { $max }
lsp-id-taken = { $id } is taken: it stands in line { $line }
explain-in-a-scene = In a scene
explain-also = See also: { $list }
explain-help = `{ $text }` says more.
explain-colour = In a scene this colour is { $number }: its linear shares of red, green and blue. The record { $text } gives it to an object; `zpg explain { $code }` says more.
explain-help-option = `{ $text }` says more at `{ $option }`.
lsp-no-uri = { $text } is not a URI
lsp-no-command = zpg has no command { $text }
lsp-no-target = zpg does not convert a scene to { $text } here
lsp-missing = { $path } is not there
lsp-unreadable = { $method } cannot be read and is left out: { $reason }
lsp-no-edits = the editor does not make edits that zpg sends; instead it can ask for the action { $kind }
lsp-has-errors = { $count ->
    [one] the scene has an error, in line { $line }: { $message }
   *[other] the scene has { $count } errors, the first in line { $line }: { $message }
}
lsp-stopped = stopped
lsp-cannot-run = zpg did not succeed: { $reason }
