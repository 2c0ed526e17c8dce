### What commands answer to people, in English.

## zpg plan

plan-on = on
plan-off = off
plan-because = line { $line }: { $id } { $text }
plan-shapes = shapes
plan-operations = operations
plan-count = { $count } × { $name }
plan-none = none
plan-media = media at once
plan-not-drawn = not drawn
plan-nothing = nothing
plan-ids-more = { $ids } and { $more } more
plan-not-seen = not seen
plan-part = line { $line }: { $id }, { $why }
plan-more = and { $more } more

## zpg render

progress-left = { $time } left
cost-seconds = load { $load } · plan { $plan } · build { $build } · trace { $trace } · encode { $encode }

## zpg crosscheck

crosscheck-answer = { $scene }{ $name } with { $with }, { $width }x{ $height }: { $answer }
crosscheck-agrees = agrees
crosscheck-agrees-in-part = agrees where compared ({ $percent } %)
crosscheck-difference = difference
crosscheck-legend-alike = alike
crosscheck-legend-differing = differing
crosscheck-legend-silhouettes = silhouettes
crosscheck-legend-silhouettes-differ = silhouettes that differ
crosscheck-legend-edges = other edges that differ
crosscheck-legend-total-reflection = total reflection
crosscheck-legend-left-out = left out
crosscheck-differs = DIFFERS
crosscheck-cannot = CANNOT BE COMPARED
crosscheck-folder = Pictures and numbers are in { $folder }

## zpg sheet

sheet-pictures = { $count ->
    [one] { $count } picture
   *[other] { $count } pictures
}
sheet-clean = no errors or warnings
sheet-scene-clean = clean
sheet-no-picture = no picture
sheet-errors = { $count ->
    [one] { $count } error, so there is no picture
   *[other] { $count } errors, so there is no picture
}
sheet-unreadable = cannot be read: { $reason }
sheet-more = { $count } more
crosscheck-off-silhouettes = off silhouettes
crosscheck-where = most of them
crosscheck-mostly = { $pixels } where { $what } is seen, in the rows { $first-row } to { $last-row } and the columns { $first-column } to { $last-column }
crosscheck-of-type = { $id } ({ $type })
crosscheck-background = the background
crosscheck-on-silhouettes = on silhouettes
crosscheck-off-edges = off edges
crosscheck-on-other-edges = on other edges
crosscheck-silhouettes = silhouettes
crosscheck-total-reflection = total reflection
crosscheck-flip = FLIP
crosscheck-povray-flip = { $flip }, from 0 to 1: how much of a difference people see
crosscheck-left-out = left out
crosscheck-exact = exact shapes
crosscheck-meshes = meshes
crosscheck-povray-off = { $pixels ->
    [one] { $pixels } pixel differs
   *[other] { $pixels } pixels differ
} by more than { $most }/255 ({ $percent } %); the largest difference is { $largest }/255, the mean { $mean }/255
crosscheck-povray-on = { $pixels ->
    [one] { $pixels } pixel differs
   *[other] { $pixels } pixels differ
}
crosscheck-povray-edges = { $pixels ->
    [one] { $pixels } pixel differs
   *[other] { $pixels } pixels differ
}, where a face, a shadow, a pattern or what is seen in mirrors and glass ends
crosscheck-povray-total = in { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
}, not compared: POV-Ray computes it differently
crosscheck-mitsuba-off = { $wrong } of { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} show another shape, place or normal ({ $percent } %)
crosscheck-mitsuba-silhouettes = not compared: { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} at the edges of shapes and faces
crosscheck-mitsuba-cut = { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} where parts without end are cut off in the translation
crosscheck-mitsuba-undecided = { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} where Mitsuba, which computes in single precision, sees something else
crosscheck-mitsuba-shared = { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
} where the surfaces of two shapes are in one place, and which of them is seen is arbitrary: { $pairs }
crosscheck-mitsuba-differences = { $pixels ->
    [one] { $pixels } pixel
   *[other] { $pixels } pixels
}; positions differ by at most { $distance }, { $share } of what is allowed; normals by at most { $angle }°
crosscheck-how-povray = with `apt-get install povray` or `brew install povray`, or from https://www.povray.org
crosscheck-how-mitsuba = with `pip install mitsuba numpy`, and name that Python with --program

## Types of records: zpg explain, the reference, editors

record-defines = Defines { $kind }.
record-changes = Changes { $kinds }.
record-defines-or-changes = On a new ID it defines { $kind }; on the ID of { $kinds } it changes that.
record-number = number
record-integer = integer
record-count = integer, a count
record-id = ID of { $kinds }
record-id-or-none = ID of { $kinds }, or 0 for none
record-file-name = file name
record-scene-units = scene units
record-degrees = degrees
record-share = a share
record-not-zero = not 0
record-between = > { $low } and < { $high }
record-within = { $low } to { $high }
record-axis = 1, 2 or 3
default-black = black
default-white = white
record-default = default { $number }
record-page = { $family }; keyword `{ $keyword }`. { $effect }
record-parameters = Parameters
record-example = Example
record-repeated = then N times:
record-repeated-again = then N times again:
record-optional = then all of these or none, on the record's last line:

## Editors

hint-row = row { $row }:
hint-profile = points, radius ≤ { $radius }, y { $low } to { $high }
hint-profile-doc = the extent of the profile
hover-values-more = and { $more } more
hover-parameter = { $rule }, number { $number } of { $count } of { $type-a }
hover-undefined = { $id } is not defined
hover-line = (line { $line })
hover-colour = Colour { $colour }, shown as `{ $shown }`
hover-uses = Used { $uses ->
    [0] nowhere
    [one] once
   *[other] { $uses } times
}, changed { $changes ->
    [0] nowhere
    [one] once
   *[other] { $changes } times
}
hover-bounds = Bounds: { $x }, { $y }, { $z }
hover-bounds-empty = Bounds: empty
hover-side = { $axis } { $low } to { $high }

## zpg farm

farm-next = { $path } says how to start it.
farm-summary =
    { $tasks ->
        [one] One task
       *[other] { $tasks } tasks
    } of about { $each } on { $cores ->
        [one] one processor
       *[other] { $cores } processors
    }, { $all } of computing in all. { $tiles ->
        [one] A task is a picture.
       *[other] A task is one of the { $tiles } bands of a picture.
    } Reading and building takes { $build } of each task.{ $chunk ->
        [one] { "" }
       *[other] { " " }{ $chunk } tasks are drawn in one go.
    }

## zpg alone

start =
    zpg: tools for scenes in the ZPG scene language

      zpg new scene.zpg      writes a scene to start with
      zpg check scene.zpg    says what is wrong, and what to write instead
      zpg fmt scene.zpg      puts each record on a line of its own and aligns the numbers
      zpg render scene.zpg   draws the scene into scene.png
      zpg explain sphere     describes a type of record or a finding

    `zpg --help` lists all commands, `zpg render --help` all options of one.
