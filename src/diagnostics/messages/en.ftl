### What zpg says, in English.
###
### A message is named by a code, and by the case where a code has several. Its attributes: `.label`
### is written at the place itself, `.note` and `.help` below it, `.fix` is the title of a fix; others
### are named by the rule. A name of the language in the place $type has further forms: $type-a, with
### its article, and $type-capital.

## Lists and what stands around findings

list-or = { $first } or { $last }
list-and = { $first } and { $last }
list-clauses = { $first }, and { $last }

here = here
guess = (a guess)
or-fix = or { $title }
fix-on-line = on line { $line }, { $title }

error = error
warning = warning
note = note
style = style

tally-clean = All checks passed!
tally-incomplete = Nothing was found in { $files ->
    [one] { $files } file
   *[other] { $files } files
}; what could not be read was not checked.
tally-errors = { $count ->
    [one] { $count } error
   *[other] { $count } errors
}
tally-warnings = { $count ->
    [one] { $count } warning
   *[other] { $count } warnings
}
tally-notes = { $count ->
    [one] { $count } note
   *[other] { $count } notes
}
tally-style = { $count ->
    [one] { $count } style remark
   *[other] { $count } style remarks
}
tally-found = Found { $findings } in { $files ->
    [one] { $files } file
   *[other] { $files } files
}{ $fixable ->
    [0] { $unsafe ->
        [0] .
       *[other] ; { $unsafe } can be fixed with `zpg check --fix --unsafe-fixes`.
    }
   *[other] ; { $fixable } can be fixed with `zpg check --fix`{ $unsafe ->
        [0] .
       *[other] , { $unsafe } more with `--unsafe-fixes`.
    }
}
fixed = Fixed { $count ->
    [one] { $count } finding
   *[other] { $count } findings
} in { $files ->
    [one] { $files } file
   *[other] { $files } files
}.
change = { $place }: { $old } → { $new }
change-nothing = nothing
allowed = Allowed { $count ->
    [one] { $count } finding
   *[other] { $count } findings
} in { $files ->
    [one] { $files } file
   *[other] { $files } files
}.
would-fix = Would fix { $count ->
    [one] { $count } finding
   *[other] { $count } findings
} in { $files ->
    [one] { $files } file
   *[other] { $files } files
}.
diff-left = `--diff --unsafe-fixes` shows { $count ->
    [one] { $count } guess
   *[other] { $count } guesses
} more.
diff-no-safe-fixes = No safe fixes available; `zpg check` shows { $count ->
    [one] { $count } finding
   *[other] { $count } findings
}{ $unsafe ->
    [0] .
    [one] , and `--diff --unsafe-fixes` { $unsafe } guess.
   *[other] , and `--diff --unsafe-fixes` { $unsafe } guesses.
}
diff-no-fixes = No fixes available; `zpg check` shows { $count ->
    [one] { $count } finding
   *[other] { $count } findings
}.
folded = { $count ->
    [one] { $count } more finding like these nine, at { $places }
   *[other] { $count } more findings like these nine, at { $places }
}
folded-row = { $count ->
    [one] { $count } more record like the one on line { $line }, at { $places }
   *[other] { $count } more records like the one on line { $line }, at { $places }
}
folded-cut = { $count ->
    [one] { $count } more finding like these nine, at { $places }
   *[other] { $count } more findings like these nine, the first at { $places }
}

## Shared phrases

fix-write = write { $number }
fix-write-all = { $count ->
    [one] write { $number } in this record
   *[other] write { $number } in all { $count } records
}
fix-space = if a space is missing, write { $number }
fix-defined = write { $number } in the definition above
fix-both-ways = if both directions have the same value, write { $number }
fix-czech-key = on a Czech keyboard { $key } is the key of { $digit }: write { $number }
fix-type = write `{ $number }` ({ $type })
fix-types = exchange the types of both records: write `{ $number }` ({ $type }) here
fix-lost-type = put the type `{ $number }` ({ $type }) after the ID
fix-comment = turn this into a comment
fix-doubled = drop the numbers that stand there twice
fix-tinted = if the three numbers are the transmitted parts of red, green and blue, write { $number }
fix-normal = if { $text } is the normal of the plane and the rest a point of it, write { $number }
fix-moved = write the ellipsoid { $number }, and its centre as a translation
fix-quad = if these are four corners, write two triangles and their union
fix-flat-profile = leave out the third number of each point, which is 0
fix-colour-each = write the colour { $text } once a point, { $count } times
fix-colour-apart = write the type `{ $number }` ({ $type }), and the colour { $text } as a record of its own
fix-operation = insert `{ $text }` above the other records of its ID: nothing uses { $first } and { $last } yet
fix-difference = a minus does not mean the complement here; the intersection with the complement of { $id } is a difference: write { $number }
fix-union = insert `{ $text }` above this record: a union of the two objects that nothing uses yet
fix-switch-on = { $count ->
    [one] take the record of { $id } out of its comment
   *[other] take the record of { $id } and what it needs out of their comments
}
fix-first-operand = write { $number } for { $id }: it is the first operand of the record in the comment
fix-without-light = leave out the union { $other }, and write { $number } in its place
fix-switch-off = do without { $id }: put the { $type } { $other } into a comment, too, and write { $number } for { $other }
fix-again = remove it: the same record stands above
fix-joined = write { $number }, and give the refractive index { $id } the ID { $other }, so that one property has both
fix-decimal-comma = if { $text } has a decimal comma, write { $number }
lack = the numbers here may be { $have }, with { $missing } ({ $parameter }) left out
lack-any = the parameters are, in order, `{ $missing }`; which of them are missing cannot be told
lost = its definition may be missing; `--unsafe-fixes` takes none of these guesses
no-part = a light shines by itself; it is not part of an object
choose = several guesses are as good: choose one, since `--unsafe-fixes` takes none of them
undecided = `--unsafe-fixes` does not take this guess: only you know whether it is meant
refused = `--unsafe-fixes` takes no guess here: none of them leaves fewer findings
switched-off = the record of { $id } stands in the comment on line { $line }
behind-sign = line { $behind } is not in a comment: its first `#` ends the comment before it
comment-ends = a comment ends at its second `#`; whatever comes after it is read as numbers
assignment-ids = ID is that of the object, T that of its texture or colour, and O that of its optical property; 0 means none
smaller-matrix = a 3 × 3 matrix of nine numbers is written with 16: a 0 behind each row, and 0 0 0 1 as the last row
alpha = alpha is not part of a colour: what an object lets through is `kt` of its optics (`-201`)
quaternion = these four numbers may be a quaternion; it does not turn about the axis x, y or z, so write it as a rotation matrix (`-4`)
fix-lamp = write the intensity 1, and the colour as a record of its own
fix-lamp-place = write the intensity 1, and the position as a record of its own
fix-angle-last = the field of view comes last: write { $number }
fix-apart = write { $text } as a record of its own ({ $type })
fix-copy = write it as a copy of { $text } and its translation
fix-apart-both = write { $text } as two records of their own: a translation and a colour
fix-sign-apart = write `{ $number }`, and { $text } as a record of its own ({ $type })
fix-sign-apart-both = write `{ $number }`, and { $text } as two records of their own: a translation and a colour
fix-flat = write the rectangle in the plane z = 0, and the records that bring it to its place: { $records }
fix-origin = leave out the position { $text }: this shape is at the origin
fix-inline = { $count ->
    [one] write the colour { $text } as a record of its own
   *[other] write the colours { $text } as records of their own
}
fix-equation = if this is meant as the { $type } of two objects, write { $number }
fix-block = write it as records
fix-block-angle = write it as records; POV-Ray's `angle` spans the width; the angle that spans the height is { $number } for 4:3
fix-block-plane = if this is POV-Ray's `plane`, whose d has the other sign, write it as records
fix-clauses = write a record for the shape and one for each of its properties
fix-clauses-some = write a record for the shape and one for each of its properties that records have; the others become a comment
fix-properties = write each property and each transformation as a record of its own
fix-properties-some = write each property and each transformation as a record of its own; what no record can say becomes a comment
fix-colour-id = { $count ->
    [one] write the ID of this colour, { $text }
   *[other] write the IDs of these colours, { $text }
}
fix-cylinder = write the { $type } { $text }
fix-point = if { $text } is the point to look at, write { $number }: a direction is that point minus the position
fix-look-at = if { $text } is the point to look at, write the direction { $way } (that point minus the position) and the up vector { $number }
fix-parts = write it as several records ({ $type }) of two objects each
fix-angle = write the angle { $number } at the end
fix-lost-number = if { $name } is missing, write { $number } in its place
fix-labelled = leave out the words
fix-labelled-point = leave out the words, and write the point to look at as a direction: that point minus the position
fix-part = if { $text } is { $parameter }, write { $number }
fix-turns = write one rotation for each axis, about x first
fix-quaternion = as the quaternion { $order } it is { $number }: an angle in degrees, and an axis
fix-up = write the up vector { $number }
fix-lay = lay the floor across the y axis: write { $number }
fix-normal-sign = change the sign of the normal: write { $number }
fix-per-cent = if the factors of { $text } are in per cent, write { $number }
leading-zero = a number in this record begins with a zero; write { $number } and this message goes away
fix-ten-times-smaller = if the subtracted object should be ten times smaller, write { $number } for { $id }
fix-place-and-view = swap position and direction: write { $number }
fix-sign-of-place = change the sign of { $axis } of the camera: write { $number }
fix-view-and-up = swap the two vectors: look along { $number }, with { $up } up
fix-free-id = give it the ID { $number }
fix-chain = { $count ->
    [one] give this operation the new ID { $number }, and write { $number } for { $text } in all records below
   *[other] give each of these { $count } operations an ID of its own ({ $number }), which the next one uses in place of { $text }
}
fix-named-id = give it a free ID: write { $number }
fix-own-id = give it the ID { $number }, and write that in { $count ->
    [one] the assignment to { $text }
   *[other] the assignments to { $text }
}, too
defined-here = { $id } is defined here
declared-here = { $id } is declared here

## The text

E001 = { $text } means nothing here
    .label = a number was expected
    .help = remove it, or put it into a comment: `# … #`
E001-sign = { E001 }
    .label = a minus stands right before its number
    .help = join it to the number behind it, or remove it

E001-slashes = { $text } begins no comment here: comments stand between two `#`
    .label = { $count ->
        [one] what follows is read as numbers
       *[other] what follows is read as numbers, as on { $count } lines
    }
    .fix = { $count ->
        [one] turn this into a comment
       *[other] turn all { $count } into comments
    }

E002 = this comment is never closed
    .label = read as if it ended with this line
    .help = a `#` begins a comment, and a second `#` must end it
    .fix = close the comment at the end of the line
    .fix-inner = take out the `#` within the comment

E003 = { $text } is not a number
    .label = malformed number
    .help = numbers look like `3`, `-0.5` or `1.5e-3`; the minus is the plain `-` of the keyboard
    .fix = { fix-write }
E003-degrees = { E003 }
    .label = { E003.label }
    .help = an angle is a number alone, in degrees, without a sign for them
    .fix = { fix-write }
E003-decimal-comma = { $text } has a decimal comma
    .label = read as { $number }
    .help = numbers are written with a decimal point
    .fix = { fix-write }
E003-decimal-commas = { $text } and other numbers of this line have a decimal comma, { $count } in all
    .label = read as { $number }
    .help = { E003-decimal-comma.help }
    .fix = write a point in each
E003-dashes = { $text } is not a number: { $count ->
    [one] { $count } number in this file has a typographic dash for its minus
   *[other] { $count } numbers in this file have a typographic dash for their minus
}
    .label = a dash, not a minus
    .help = copying from a PDF turns a minus into a dash; here it must be `-`
    .fix = write `-` in { $count ->
        [one] this place
       *[other] all { $count } places
    }
E003-colour = a colour is three numbers, not { $text }
    .label = in linear red, green and blue: { $number }
    .help = the numbers go from 0 to 1 and are linear; hexadecimal digits and the names of CSS are sRGB
    .fix = { fix-write }
E003-material = { $text } is the name of a material, not its numbers
    .label = such as { $number }
    .help = `-201 kd ks kt` says which shares of light are scattered, mirrored and let through; `-203` is the refractive index
    .fix = { fix-write }
E003-glued = { $text } is not one number, but several
    .label = a space is missing here: { $number }
    .help = with the space the record has as many numbers as it takes
    .fix = { fix-write }

E004 = { $text } is too large
    .label = no double-precision number is that large
    .help = the largest is about 1.8e308
E004-count = { $text } points are more than any file can hold
    .label = N, the number of profile points
E004-id = the ID { $text } is too large
    .label = IDs go up to 2147483647

E005 = { $text } cannot be an ID
    .label = an ID was expected here
    .help = a record begins with its ID, a whole number from 1 to 2147483647
E005-negative = { E005 }
    .label = IDs are positive
    .help = { E005.help }
E005-lost = this { $type } has no ID
    .label = this is the type, { $number }; an ID belongs in front of it
    .help = { $type-a } is written { $header }
E005-name = this { $type } has no ID: a record begins with its ID
    .label = the name of type { $number } is not an ID
    .help = { E005-lost.help }
E005-swapped = { $text } cannot be an ID here: ID and type are swapped
    .label = the render record begins with { $number }
    .help = the render record always has ID 1 and type 9999
    .fix = { fix-write }
E005-drawn = the render record begins with { $number }; the ID of what is drawn follows
    .label = the type stands behind that ID
    .help = { E005-swapped.help }
E005-exchanged = ID and type are swapped: { $text } is the type, { $number } the ID
    .label = { E005.label }
    .help = a record begins with its ID, and its type follows
    .fix = { fix-write }

E006 = there is no type after the ID { $text }
    .label = a record type was expected after this ID
    .help = a record is `ID TYPE parameters…`
E006-word = { $text } is not a record type
    .label = a type number was expected
    .help = { $name ->
        [none] to find the number of a type, run `zpg explain` with its name, such as `zpg explain sphere`
       *[other] `zpg explain { $name }` has the number of this type, and how it is written
    }
E006-lost = this record has no type: its numbers fit type { $number }, { $type-a }
    .label = the type is missing after this ID

E007 = there is no record type { $text }
    .label = unknown type
E007-proposal = { E007 }
    .label = { E007.label }
    .help = these parameters fit type { $number }, { $type-a }
    .fix = { fix-type }
E007-sign = the type has lost its minus: { $number } is { $type-a }
    .label = the numbers after it fit type { $number }
E007-minus = { $kinds ->
    [one] { $count } records have lost the minus of their type { $number } ({ $type })
   *[many] { $count } records have lost the minus of their type; here it should be { $number } ({ $type })
}
    .label = a minus is missing here
    .help = types of operations, properties, lights and cameras are negative; copying from a PDF may lose the minus
    .fix = write the minus in { $count ->
        [one] this record
       *[other] all { $count } records
    }

E008 = too few numbers: { $type-a } takes { $fewer ->
    [none] {""}
   *[other] { $fewer } or{" "}
}{ $wanted ->
    [one] { $wanted } number
   *[other] { $wanted } numbers
}, here { $got ->
    [0] are none
    [one] is { $got }
   *[other] are { $got }
}
    .label = { $off ->
        [one] { $off } number missing
       *[other] { $off } numbers missing
    }
    .help = { $type-capital }: { $header }
E008-points = { E008 }
    .label = N is { $says }, but { $points ->
        [one] { $points } point follows
       *[other] { $points } points follow
    }
    .help = { E008.help }
    .fix = { fix-write }
E008-row = { E008 }
    .label = this line has fewer than the others
    .help = { E008.help }
    .begin = the { $type } begins here
E008-sign = { E008 }
    .label = the type has lost its sign
    .help = with a sign it is right: { $meant-capital } { $header }
    .fix = { fix-write }
E008-count = this { $type } has no number of points
    .label = N is missing after the type
    .help = { E008.help }
E008-file = this { $type } has no file name
    .label = a file name is missing after the type
    .help = { E008.help }

E009 = too many numbers: { $type-a } takes { $fewer ->
    [none] {""}
   *[other] { $fewer } or{" "}
}{ $wanted ->
    [one] { $wanted } number
   *[other] { $wanted } numbers
}, here { $got ->
    [0] are none
    [one] is { $got }
   *[other] are { $got }
}
    .label = { $off ->
        [one] { $off } number too many
       *[other] { $off } numbers too many
    }
    .help = { $type-capital }: { $header }
E009-points = { E009 }
    .label = N is { $says }, but { $points ->
        [one] { $points } point follows
       *[other] { $points } points follow
    }
    .help = { E009.help }
    .fix = { fix-write }
E009-space = { E009 }
    .label = three coordinates for each point
    .help = a point of a profile is x y, the distance from the axis and the height: { $header }
E009-row = { E009 }
    .label = this line has more than the others
    .help = { E009.help }
    .begin = the { $type } begins here
E009-file = this { $type } has something behind its file name
    .label = this is too much
    .help = { E009.help }

E010 = { $text } is not an integer
    .label = { $parameter } must be a whole number, written without a point
    .fix = { fix-write }
E010-reference = { E010 }
    .label = an integer belongs here: the ID of { $parameter }
    .fix = { fix-write }

E011 = { $text } is not a file name
    .label = { $parameter } was expected
    .help = a file name is one word, or stands in double quotes

E012 = the word { $text } means nothing here
    .label = a number was expected
    .help = if this is a comment, put it between two `#`
E012-axis = the axis { $text } is written as a number
    .label = 1 is x, 2 is y, 3 is z
E012-axis-first = { E012-axis }
    .label = { E012-axis.label }
    .help = the angle comes first, then the axis
E012-parameter = the word { $text } stands in the place of a number
    .label = a number was expected
    .help = the record is written { $header }
E012-angle = the rotation lacks its angle: { $text } is its axis
    .label = the angle goes before the axis
    .help = the record is written { $header }; the axis is 1 for x, 2 for y, 3 for z
E012-file-name = the file name { $text } is more than one word
    .label = this should be one word
    .help = a file name with spaces, commas or brackets stands in double quotes
    .fix = { fix-write }

E013 = { $text } points are more than can be handled
    .label = N, the number of points; { $got ->
        [one] { $got } number follows
       *[other] { $got } numbers follow
    }

E014 = this does not look like a scene: { $lines ->
        [one] its only line does not begin with a number
       *[other] { $numbers } of { $lines } lines begin with a number
    }
    .label = this line does not
    .help = a scene is made of records, `ID TYPE PARAMETER…`, and of `# comments #`; at least half of its lines begin with a number
    .comments = where the other lines are comments, put each between two `#`
E014-numbers = this does not look like a scene: { $all ->
        [one] its only number is not in a record
       *[other] { $numbers } of { $all } numbers are in records
    }
    .label = this is not a record
    .help = a scene is made of records, `ID TYPE PARAMETER…`; at least half of its numbers are in records that can be read, or that have one small mistake
E014-known = this is { $kind ->
        [picture] { $name-a } picture
        [recording] { $name-a } recording
        [film] { $name-a } film
        [archive] { $name-a } archive
        [document] { $name-a } document
        [program] { $name-a } program
        [font] { $name-a } font
        [model] { $name-a } 3D model
        [database] { $name-a } database
       *[file] { $name-a } file
    }, not a scene
E014-binary = this is binary data, not a scene
E014-pov-ray = this looks like a POV-Ray scene
    .label = a line of POV-Ray's language
    .help = POV-Ray scenes cannot be read; `zpg convert FILE --to pov` translates a scene the other way
E014-long = a comment or word of this file takes 256 MiB or more
    .label = it begins here
    .help = end a comment with `#`
E014-json = this is JSON, not a scene
E014-scene-json = this is a scene written as JSON
    .help = it is read if its name ends with .json; `zpg convert FILE.json --to zpg` writes it as records

E015 = { $why }

W314 = this { $type } takes its last numbers from a line that would be a record of its own
    .label = taken from the start of this line
    .begin = the record begins here
    .note = by itself the line would read { $line }
    .help = if a number is missing above, add it: { $header }
W314-row = this { $type } takes { $wanted ->
    [one] { $wanted } number
   *[other] { $wanted } numbers
}, here { $got ->
    [one] is { $got }
   *[other] are { $got }
}: a row of { $off } is missing, and the next line is read as its last row
    .label = { W314.label }
    .begin = { W314.begin }
    .note = { W314.note }
    .help = if that line is a record, add the row above it: { $header }

N601 = the file is not valid UTF-8; it is read as Windows-1250
    .label = the first byte that is not UTF-8
    .help = save the file as UTF-8
N604 = the file is UTF-16; it is read as such, and stays so when it is written
    .label = the file begins here
N604-incomplete = the file is UTF-16 with something in it that is not a character; it is not written to
    .label = the file begins here
    .help = save the file as UTF-8

N605 = the numbers after this { $type } can be read in two ways
    .label = read as part of the { $type }
    .help = they could be records of their own: these stand on lines of their own

## IDs

lost-id-used-here = { $lost } is used here and defined nowhere
lost-id-may-be-this = it may be the record that should define { $lost }
put-lost-id-in-front = put `{ $lost }` in front
write-lost-id = write `{ $lost }`

E101 = { $id } is not defined
    .label = nothing in this file has this ID
E101-copied = { E101 }
    .label = { E101.label }
    .help = { $other-id } is defined twice: the second definition is probably that of { $id }
E101-hidden = { E101 }
    .label = { E101.label }
    .help = ID { $id } is defined inside the comment that begins on line { $line }
E101-switched-off = { E101 }
    .label = no record outside of comments has this ID
E101-missing = { E101 }: its definition may be missing
    .label = this record needs the definition of { $id }
    .help = put the record that defines { $id } above this one
E101-missing-colour = { E101 }: the definition of this colour may be missing
    .label = { E101.label }
    .help = put the colour above this record, as in `{ $id } -701 1 1 1`
E101-missing-lamp = { E101 }: a lamp `{ $id } -402` may be missing
    .label = this moves or colours something that nothing defines
    .help = put a lamp above this record, as in `{ $id } -402 1`
E101-missing-operation = { $id } is no object: the record of the object { $id } may be missing
    .label = nothing above this is an object with this ID
E101-missing-shape = { $id } is no object: the record of the shape { $id } may be missing
    .label = nothing above this is a shape with this ID
    .help = put the record of the shape above all others that begin with { $id }
E101-missing-union = { E101 }: its definition may be missing
    .label = { E101.label }
E101-no-id = { $number } is not an ID
    .label = the ID of something was expected

E102 = the ID { $id } is defined already
    .label = this { $type } would be a second definition
    .help = give it an ID of its own
    .first = first defined here
E102-render = there is a render record already
    .label = a scene has one, with the ID 1
    .help = remove one of them
    .first = { E102.first }
E102-property = { E102 }
    .label = { E102.label }
    .first = { E102.first }, as a property that nothing has yet
    .help = if this { $type } is to have that property, move the property after it
    .fix = { $count ->
        [one] move that record below this definition
       *[other] move those { $count } records below this definition
    }
E102-scenes = this file seems to hold two scenes: { $count } IDs are defined twice
    .label = the second scene begins here
    .help = give the records of one scene other IDs, and keep one render record
    .first = the first scene has this ID, too
    .fix = add { $number } to all IDs of the second scene, and draw both

E102-renders = this file seems to hold two scenes: both have a render record
    .label = the second scene begins here
    .help = a scene has one render record; a union of the objects of both draws all
    .render = the first scene ends with this one
    .fix = draw the objects of both

E103 = { $id } is { $kind-a }, not { $kinds }
    .label = expected here: { $parameter }
E103-changed = { $id } is { $kind-a }; { $type-a } applies only to { $kinds }
    .label = the ID of { $kinds } was expected

E104 = { $id } is used in its own definition
    .label = { $parameter } must be something else

E105 = the render record must have the ID 1
    .label = this ID
    .fix = write `1`
E105-swapped = the ID of the render record and the ID of what is drawn are swapped
    .label = the render record has the ID 1, and { $id } is what is drawn
E105-again = the render record must have the ID 1, and there is more than one
    .label = this ID
    .help = keep one of them
E105-other = the ID 1 is reserved for the render record, not for { $type-a }
    .label = this ID
    .help = use another ID
E105-objects = { E105-other }
    .label = { E105-other.label }
    .help = { E105-other.help }
    .fix = write { $number } here and wherever this ID is used

E106 = there is no render record
    .label = nothing says what is to be drawn
    .help = add `1 9999 OBJECT BACKGROUND`: for OBJECT the ID of what is to be drawn, for BACKGROUND the ID of a colour, or 0 for black
    .fix = add { $text }

E107 = { $id } is used before it is defined
    .label = not defined yet
    .help = a scene is read from top to bottom: what is used belongs above
    .later = defined here
    .fix = move the definition of { $id } up
    .fix-down = move this record below the definition of { $id }
E107-changed = { $id } is changed before it is defined
    .label = not defined yet
    .help = a scene is read from top to bottom: this record belongs below the definition
    .later = defined here
    .fix = move the record below the definition
E107-cycle = { $id } and { $own } need each other: neither can be defined first
    .label = { $own } needs { $id }, which needs { $own }
    .help = the definitions go in a circle, { $own } → { $members }; one of these references must name something else
    .later = defined here

E108 = { $id } is declared, but not defined yet
    .label = { $parameter } must be defined before it is used
E108-changed = { E108 }
    .label = { $type-a } needs something to change

## Values

E201 = { $parameter } of the { $type } must be positive
    .label = `{ $name }` is { $text }
    .fix = { fix-write }
    .fix-swap = swap height and radius

E202 = { $lower } of the { $type } is greater than { $upper }{ $others ->
    [0] {""}
   *[other] , and { $others } more
}
    .label = the lower bound
    .other = the upper bound
    .fix = swap them
    .fix-order = write all lower bounds before all upper ones
    .fix-number = write { $number } instead of { $text }
    .fix-size = if { $text } is the size, write { $number }
    .fix-centre = if { $centre } is the centre and { $text } the size, write { $number }
    .fix-half = if { $centre } is the centre and { $text } half the size, write { $number }

E203 = the { $vector } of the { $type } is the zero vector
    .label = it has no direction

E204 = this { $type } is singular: it has no inverse
    .label = it maps space onto something flat
E204-rounded = this { $type } has no inverse in double precision
    .label = it is too close to one that maps space onto something flat, or its numbers are too large or too small
E204-row = the last row of a rotation matrix must be 0 0 0 1
    .label = this row
E204-transposed = { E204-row }
    .label = { E204-row.label }
    .help = a matrix acts on columns here: a translation stands in its last column
    .fix = transpose the matrix
E204-scale = { $parameter } of the { $type } cannot be zero
    .label = `{ $name }` is { $text }
E204-product = with this { $type }, the transformations of { $id } have no inverse
    .label = numbers became too large or too small for double precision

E205 = the axis of the { $type } must be 1 for x, 2 for y or 3 for z
    .label = `{ $name }` is { $text }
E205-turned = { E205 }
    .label = { E205.label }
    .help = the angle comes first, then the axis
    .fix = swap them

E206 = { $parameter } of the { $type } must lie between { $low } and { $high }
    .label = `{ $name }` is { $text }
E206-between = { $parameter } of the { $type } must lie between { $low } and { $high }, ends excluded
    .label = `{ $name }` is { $text }
    .fix = { fix-write }
E206-least = { $parameter } of the { $type } must be at least { $low }
    .label = `{ $name }` is { $text }
E206-count = { $type-a } needs at least 2 points, not { $value }
    .label = N, the number of profile points, must be at least 2

E207 = the camera's view direction and up vector are parallel
    .label = together they must tell which way is up in the picture
    .help = the up vector is usually `0 1 0`; for a camera that looks straight down take `0 0 -1`, straight up `0 0 1`
E207-down = { E207 }
    .label = { E207.label }
    .help = the camera looks straight down: the up vector is then `0 0 -1`; or the direction is another one, as `0 -1 -3`
E207-up = { E207 }
    .label = { E207.label }
    .help = the camera looks straight up: the up vector is then `0 0 1`; or the direction is another one, as `0 1 -3`
E207-projection = this projection matrix has no ray for a part of the picture
    .label = nothing in front of the camera is seen there
    .help = the camera looks along −z: the last row of a perspective is usually 0 0 -1 0

E207-nearly = the camera's view direction and up vector are so nearly parallel that rounding hides the difference
    .label = { E207.label }
    .help = { E207.help }

E208 = { $parameter } of the { $type } cannot be negative
    .label = `{ $name }` is { $text }
    .help = a point of a profile is `x y`: x is the distance from the axis, y the height
    .fix-turned = exchange x and y of every point
    .fix = { fix-write }

E209 = the image must lie in the scene's own folder
    .label = this path leaves it
    .help = copy the image beside the scene, or into a folder there, and name it as seen from the scene
E209-backslash = a path in a scene is written with `/`
    .label = this has `\`
E209-link = { E209 }
    .label = this is a link that leaves it

E210 = the image cannot be read: { $why }
    .label = this file
    .help = the file is looked for in the scene's folder
E210-format = the image is neither a PNG nor a JPEG picture
    .label = { E210.label }
# Found and of a known format, but not readable: no help.
E210-content = { E210 }
    .label = { E210.label }

## Warnings

no-inside = it has no inside: nothing of it is drawn, and it cuts nothing
nothing-drawn = nothing of it is drawn

## Notes and style

S504 = { $count ->
    [one] { $entries } is allowed here, but not found
   *[other] { $entries } are allowed here, but not found
}
    .label = nothing to allow
    .fix = { $count ->
        [one] take it out
       *[other] take them out
    }
S504-unknown = zpg does not understand this comment
    .help = to accept a finding here, write `# zpg: allow(W307) #`, with its code or name
S504-empty = an entry of this comment is empty
    .help = to accept a finding here, write `# zpg: allow(W307) #`, with its code or name
S504-no-code = { $count ->
    [one] there is no code { $text }
   *[other] there are no codes { $text }
}
    .help = `zpg explain` lists all codes
S504-error = { $count ->
    [one] an error, { $code }, cannot be allowed
   *[other] errors cannot be allowed: { $code }
}
