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

error = error
warning = warning
note = note
style = style

tally-clean = All checks passed!
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
would-fix = Would fix { $count ->
    [one] { $count } finding
   *[other] { $count } findings
} in { $files ->
    [one] { $files } file
   *[other] { $files } files
}.
folded = { $count ->
    [one] { $count } more finding like these nine, at { $places }
   *[other] { $count } more findings like these nine, at { $places }
}
folded-cut = { $count } more findings like these nine, the first at { $places }

## Shared phrases

fix-write = write { $number }
defined-here = { $id } is defined here
declared-here = { $id } is declared here

## The text

E001 = { $text } means nothing here
    .label = a number was expected
    .help = remove it, or put it into a comment: `# … #`

E002 = this comment is never closed
    .label = it is taken to end with its line
    .help = close the comment with `#`
    .fix = close the comment at the end of the line

E003 = { $text } is not a number
    .label = malformed number
    .help = numbers look like `3`, `-0.5` or `1.5e-3`
    .fix = { fix-write }
E003-decimal-comma = { $text } has a decimal comma
    .label = read as { $number }
    .help = numbers are written with a decimal point
    .fix = { fix-write }
E003-glued = { $text } is no number, but several
    .label = a space is missing here: { $number }
    .help = the record takes as many numbers as that gives it
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
E005-swapped = { $text } cannot be an ID here: ID and type are swapped
    .label = the render record begins with { $number }
    .help = the render record always has ID 1 and type 9999
    .fix = { fix-write }

E006 = there is no type behind the ID { $text }
    .label = a record type was expected behind this ID
    .help = a record is `ID TYPE parameters…`
E006-word = { $text } is no record type
    .label = a type number was expected
    .help = `zpg explain` with a name, such as `zpg explain sphere`, tells the number of a type

E007 = there is no record type { $text }
    .label = unknown type
E007-proposal = { E007 }
    .label = { E007.label }
    .help = these parameters fit type { $number }, { $type-a }
    .fix = write `{ $number }` ({ $type })

E008 = too few numbers: { $type-a } takes { $fewer ->
    [none] {""}
   *[other] { $fewer } or{" "}
}{ $wanted ->
    [one] { $wanted } number
   *[other] { $wanted } numbers
}, here are { $got }
    .label = { $off ->
        [one] { $off } number missing
       *[other] { $off } numbers missing
    }
    .help = { $type-capital }: { $header }
E008-row = { E008 }
    .label = this line has fewer than the others
    .help = { E008.help }
    .begin = the { $type } begins here
E008-count = this { $type } has no number of points
    .label = N is missing behind the type
    .help = { E008.help }

E009 = too many numbers: { $type-a } takes { $fewer ->
    [none] {""}
   *[other] { $fewer } or{" "}
}{ $wanted ->
    [one] { $wanted } number
   *[other] { $wanted } numbers
}, here are { $got }
    .label = { $off ->
        [one] { $off } number too many
       *[other] { $off } numbers too many
    }
    .help = { $type-capital }: { $header }
E009-row = { E009 }
    .label = this line has more than the others
    .help = { E009.help }
    .begin = the { $type } begins here

E010 = { $text } is not an integer
    .label = { $parameter } must be a whole number, written without a point
    .fix = { fix-write }

E011 = { $text } is no file name
    .label = { $parameter } was expected
    .help = a file name is one word, or stands in double quotes

E012 = the word { $text } means nothing here
    .label = a number was expected
    .help = comments stand between two `#`
E012-file-name = the file name { $text } has spaces in it
    .label = this should be one word
    .help = a file name with spaces stands in double quotes
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
E014-json = this is JSON, not a scene
E014-scene-json = this is a scene written as JSON
    .help = `zpg convert FILE --to zpg` writes it as records

W314 = this { $type } takes its last numbers from a line that would be a record of its own
    .label = taken from the head of this line
    .begin = the record begins here
    .note = by itself the line would read { $line }
    .help = if a number is missing above, add it: { $header }

N601 = the file is not valid UTF-8; it is read as Windows-1250
    .label = the first byte that is not UTF-8
    .help = save the file as UTF-8
N604 = the file is UTF-16; it is read as such, and stays so when it is written
    .label = the file begins here
N604-incomplete = the file is UTF-16 with something in it that is no character; it is not written to
    .label = the file begins here
    .help = save the file as UTF-8

## IDs

lost-id-used-here = { $lost } is used here and defined nowhere
lost-id-may-be-this = it may be the record that should define { $lost }
put-lost-id-in-front = put `{ $lost }` in front
write-lost-id = write `{ $lost }`

E101 = { $id } is not defined
    .label = nothing in this file has this ID
E101-no-id = { $number } is no ID
    .label = the ID of something was expected

E102 = the ID { $id } is defined already
    .label = this { $type } would be a second definition
    .help = give it an ID of its own
    .first = defined here first
E102-render = there is a render record already
    .label = a scene has one, with the ID 1
    .help = remove one of them
    .first = { E102.first }
E102-property = { E102 }
    .label = { E102.label }
    .first = { E102.first }, as a property that nothing has yet
    .help = if this { $type } is to have that property, move the property behind it

E103 = { $id } is { $kind-a }
    .label = { $parameter } must be { $kinds }
E103-changed = { $id } is { $kind-a }; { $type-a } does not apply to it
    .label = { $kinds } was expected

E104 = { $id } is used in its own definition
    .label = { $parameter } must be something else

E105 = the render record must have the ID 1
    .label = this ID
    .fix = write `1`
E105-other = the ID 1 is reserved for the render record, not for { $type-a }
    .label = this ID
    .help = use another ID

E106 = there is no render record
    .label = nothing says what is to be drawn
    .help = add `1 9999 OBJECT BACKGROUND` with the ID of an object and of a colour (or 0)

E107 = { $id } is used before it is defined
    .label = not defined yet
    .help = move the definition up: a scene is read from top to bottom
    .later = defined here

E108 = { $id } is declared, but not defined yet
    .label = { $parameter } must be defined before it is used
E108-changed = { E108 }
    .label = { $type-a } needs something to change

## Values

E201 = { $parameter } of the { $type } must be positive
    .label = `{ $name }` is { $text }

E202 = { $lower } of the { $type } is greater than { $upper }{ $others ->
    [0] {""}
   *[other] , and { $others } more
}
    .label = the lower bound
    .other = the upper bound
    .fix = swap them

E203 = the { $vector } of the { $type } is the zero vector
    .label = it has no direction

E204 = this { $type } is singular: it has no inverse
    .label = it maps space onto something flat
E204-rounded = this { $type } has no inverse in double precision
    .label = it is too close to one that maps space onto something flat, or its numbers are too large or too small
E204-row = the last row of a rotation matrix must be 0 0 0 1
    .label = this row
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
E206-least = { $parameter } of the { $type } must be at least { $low }
    .label = `{ $name }` is { $text }
E206-count = { $type-a } needs at least 2 points, not { $value }
    .label = N, the number of profile points, must be at least 2

E207 = the camera's view direction and up vector are parallel
    .label = they must span the vertical plane of the picture
E207-projection = this projection matrix has no ray for a part of the picture
    .label = nothing in front of the camera is seen there
    .help = the camera looks along −z: the last row of a perspective is usually 0 0 -1 0

E207-nearly = the camera's view direction and up vector are parallel up to the rounding of doubles
    .label = { E207.label }

E208 = { $parameter } of the { $type } cannot be negative
    .label = `{ $name }` is { $text }

E209 = the image must lie in the scene's own folder
    .label = this path leaves it
    .help = copy the image beside the scene and name it without a folder
E209-link = { E209 }
    .label = this is a link that leaves it

E210 = the image cannot be read
    .label = { $why }
    .help = the file is looked for in the scene's folder
E210-format = { E210 }
    .label = it is neither a PNG nor a JPEG picture
    .help = { E210.help }

## Warnings

W301 = the parts of a colour lie between 0 and 1; here { $parts }
    .label = taken as it is
    .note = a part above 1 makes a surface brighter than the light that falls on it, a negative one takes light away; a light has an intensity besides its colour
    .bytes = these look like numbers from 0 to 255
    .divide = divide by 255
    .fix = write the nearest that is in range
W301-point = the parts of a colour lie between 0 and 1; at profile point { $point }, { $parts }{ $others ->
    [0] {""}
    [one] , and { $others } more colour is out of range
   *[other] , and { $others } more colours are out of range
}
    .label = { W301.label }
    .note = { W301.note }
    .bytes = { W301.bytes }
    .divide = { W301.divide }
    .fix = { W301.fix }

sum-in-red = kd + ks + kt = { $red } in red
sum-in-green = kd + ks + kt = { $green } in green
sum-in-blue = kd + ks + kt = { $blue } in blue

W302 = this surface gives off more light than it gets: kd + ks + kt = { $sum }
    .label = more than 1
    .help = the three parts share the light that arrives; their sum should be at most 1
W302-red = { W302 } in red
    .label = { W302.label }
    .help = { W302.help }
W302-green = { W302 } in green
    .label = { W302.label }
    .help = { W302.help }
W302-blue = { W302 } in blue
    .label = { W302.label }
    .help = { W302.help }

W303 = this matrix is not a rotation: { $deeds }
    .label = applied as it is given
    .help = for a scaling or a mirror image on purpose, use type -3
    .fix = write the nearest rotation
    .mirrors = it mirrors
    .scales = its columns have the lengths { $x }, { $y } and { $z }, not 1
    .skews = its columns are not at right angles
    .rounded = its entries are off by more than 1e-6

W304 = the matrix of the quadric { $id } is not symmetric: { $first } is { $first-number } but { $mirror } is { $mirror-number }{ $more ->
    [0] {""}
    [one] , and { $more } more pair differs
   *[other] , and { $more } more pairs differ
}
    .label = { $first }
    .other = { $mirror }
    .note = only the sum of the two counts: the quadric is drawn as if both were their mean
    .fix = { $pairs ->
        [one] write their mean in both places
       *[other] write the mean of both in all { $pairs } pairs
    }

no-inside = it has no inside: nothing of it is drawn, and nothing is cut by it
nothing-drawn = nothing of it is drawn

W305 = the { $type } { $id } has no volume
    .note = { no-inside }
W305-box = the { $type } { $id } has no volume: { $pairs }
    .label = { $lower }
    .other = { $upper }
    .note = { no-inside }
W305-rectangle = the { $type } { $id } has no area: { $pairs }
    .label = { $lower }
    .other = { $upper }
    .note = { nothing-drawn }
W305-triangle = the { $type } { $id } has no area: its three corners lie on one line
    .label = the corners
    .note = { nothing-drawn }
W305-triangle-nearly = the { $type } { $id } has no area up to the rounding of its numbers: its three corners lie on one line
    .label = the corners
    .note = what is drawn of it depends on that rounding
W305-cone = the { $type } { $id } has no volume: its height is 0
    .label = h
    .note = { no-inside }
W305-point = the { $type } { $id } has no volume: a single point satisfies it
    .label = xᵀQx is nowhere less than 0
    .note = { no-inside }
W305-line = the { $type } { $id } has no volume: only the points of a line satisfy it
    .label = { W305-point.label }
    .note = { no-inside }
W305-plane = the { $type } { $id } has no volume: only the points of a plane satisfy it
    .label = { W305-point.label }
    .note = { no-inside }
W305-axis = the { $type } { $id } has no volume: all points of its profile lie on the axis
    .label = the profile
    .note = { no-inside }
W305-profile = the { $type } { $id } has no volume: its profile surrounds no area
    .label = the profile
    .note = { no-inside }

W305-profile-nearly = the { $type } { $id } has no volume up to the rounding of its numbers: its profile surrounds no area
    .label = the profile
    .note = what is drawn of it depends on that rounding

W306 = no point satisfies the quadric { $id }
    .label = this matrix
    .note = xᵀQx is greater than 0 everywhere: the object is empty, nothing of it is drawn, and taking it away from another one changes nothing
W306-ball = { W306 }
    .label = { W306.label }
    .note = { W306.note }
    .help = for a ball of radius r, m11 to m33 are 1 and m44 is -r²
    .fix = turn the sign of m44
W306-full = every point satisfies the quadric { $id }
    .label = { W306.label }
    .note = xᵀQx is nowhere greater than 0: the object fills all of space, has no surface that could be drawn, and leaves nothing of what it is taken away from
W306-zero = every point satisfies the quadric { $id }
    .label = { W306.label }
    .note = xᵀQx is 0 everywhere: the object fills all of space and has no surface that could be drawn

W307 = in the union { $id }, the { $one } { $one-id } and the { $two } { $two-id } overlap, and they are of different media: ({ $x }, { $y }, { $z }) is in both
    .label = the first operand owns what both hold
    .first = the { $one }
    .second = the { $two }
    .note = the surface of the second one is not seen where the first one is: the picture depends on the order of the operands
    .help = take one away from the other, or write the overlap as a part with properties of its own
    .fix = write it as (A ∩ B) ∪ (A − B) ∪ (B − A)

W307-open = in the union { $id }, the { $one } { $one-id } and the { $two } { $two-id } overlap, look different, and are cut open: at ({ $x }, { $y }, { $z }) the cut goes through both
    .label = { W307.label }
    .first = { W307.first }
    .second = { W307.second }
    .note = the cut face looks like the first one where both are: the picture depends on the order of the operands
    .help = { W307.help }
    .fix = { W307.fix }

W308 = the intersection { $id } keeps two looks: the { $first } { $first-id } and the { $second } { $second-id } differ in { $aspects ->
    [texture] colour
    [optics] optical property
    [index] refractive index
    [texture-optics] colour and optical property
    [texture-index] colour and refractive index
    [optics-index] optical property and refractive index
   *[all] colour, optical property and refractive index
}
    .label = nothing is assigned to { $id }
    .note = every piece of its surface has the properties of the operand that it comes from
    .help = if it is meant to look the same all over, assign properties to the result: `{ $id } -299 TEXTURE OPTICS`
    .fix = give { $id } the properties of { $source }

W309 = this { $change } of { $id } comes too late for the { $taker } { $taker-id }{ $more ->
    [0] {""}
    [one] , and so does { $more } more change
   *[other] , and so do { $more } more changes
}
    .label = this reaches nothing that is used
    .taken = { $id } is taken here
    .note = an operation takes its operands as they are at that point
    .help = move this in front of the { $taker }, or change { $taker-id } in place of { $id }
W309-property = the { $type } { $id } is changed too late: { $taker-id } has taken it as it was{ $more ->
    [0] {""}
    [one] {" "}({ $more } more change likewise)
   *[other] {" "}({ $more } more changes likewise)
}
    .label = { W309.label }
    .taken = { $id } is taken here
    .note = properties and colours are taken as they are at that point
    .help = move this in front of the record that takes { $id }

W310 = the { $type } { $id } is never used
    .label = nothing that is drawn has it
    .help = assign it with `ID -299 TEXTURE OPTICS`, or remove it
W310-object = the { $type } { $id } is not part of what is drawn
    .label = nothing that is drawn is made of it
    .help = join it to the scene with a union, or remove it
W310-placeholder = { $id } is declared, but neither defined nor used
    .label = a placeholder of nothing
    .help = define it below, or remove the declaration

W311 = the bounding box of the object { $id } is too small: ({ $x }, { $y }, { $z }) is a point of its surface
    .label = this box shall hold the object
    .note = the picture is the same, but a program that trusts the box leaves out what lies outside
    .fix = enlarge it
W311-sphere = the bounding sphere of the object { $id } is too small: ({ $x }, { $y }, { $z }) is a point of its surface
    .label = this sphere shall hold the object
    .note = the picture is the same, but a program that trusts the sphere leaves out what lies outside
    .fix = { W311.fix }

W312 = the box of the render record cuts the scene: the { $type } { $id } reaches out of it at ({ $x }, { $y }, { $z })
    .label = what lies outside of this box is invisible
    .shape = this reaches out of it
    .note = the cut is not closed: one looks into the object
    .help = make the box larger, or say that the cut is meant: `# zpg: allow(W312) #`
W312-outside = nothing will be seen: all of the object { $id } lies outside of the box of the render record, its { $axis } is { $where ->
        [above] at least
       *[below] at most
    } { $reach } everywhere
    .label = { $name }, the side of the box
    .note = what lies outside of the box is invisible, for all rays

W312-part = nothing will be seen of the { $type } { $id }: all of it lies outside of the box of the render record, its { $axis } is { $where ->
        [above] at least
       *[below] at most
    } { $reach } everywhere{ $others ->
        [0] {""}
        [one] ; { $others } other part lies outside too
       *[other] ; { $others } other parts lie outside too
    }
    .label = { $name }, the side of the box
    .shape = this is not drawn
    .note = { W312-outside.note }
    .help = make the box larger, or take out what is not drawn

W313 = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: of it,
   *[part] has a surface in it: of that,
} the intersection { $id } keeps what is inside the { $other } { $other-id }
    .label = this operand
    .surface = the { $shape } { $shape-id } is a surface: it has no inside
    .help = operations are made for solids: a half-space (type 4) has the inside that a plane (type 3) lacks, a thin box that of a rectangle
W313-outside = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: of it,
   *[part] has a surface in it: of that,
} the difference { $id } keeps what is outside the { $other } { $other-id }
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-tool = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: taking it away
   *[part] has a surface in it: taking that away
} from the { $other } { $other-id } changes nothing
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-both = the { $operand } { $operand-id } and the { $other } { $other-id } are surfaces: their intersection { $id } is empty
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-complement = the { $operand } { $operand-id } { $what ->
    [whole] is a surface: its complement { $id } is all of space
   *[part] has a surface in it: the complement { $id } ignores that
}
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }

W315 = this comment hides { $count ->
    [one] a record, the { $type } { $id }
   *[other] { $count } records, from the { $type } { $id } on
}
    .label = the comment begins here
    .first = this would be a record
    .end = the comment ends here
    .help = close the comment with `#` on its own line; what is not wanted any more is better removed

W316 = there are { $count } cameras and none is selected: { $id }, the last one, takes the picture
    .label = this one is used
    .unused = { $other } is not used
    .help = select one with `ID -502 CAMERA`, or two for a stereo picture with `ID -503 LEFT RIGHT`
    .fix = select { $id }

W318 = this refractive index has no effect: no light goes through the { $object } { $object-id }
    .label = kt is 0 wherever this index counts
    .help = light is refracted where a part of it is transmitted: give it an optical property with kt > 0, such as `{ $object-id } -201 0 0.1 0.9`
W318-below-one = a refractive index is at least 1, that of a vacuum; here { $parts }
    .label = less than 1
    .help = the index is that of the object's own material; what surrounds it counts by itself

W319 = the { $operation } { $id } is empty: the { $one } { $one-id } and the { $two } { $two-id } lie apart, { $axis } ≤ { $end } and { $axis } ≥ { $begin }
    .label = nothing is left
    .one = the { $one }
    .two = the { $two }
    .note = nothing of it is drawn
W319-balls = the { $operation } { $id } is empty: the { $one } { $one-id } and the { $two } { $two-id } lie apart, their centres by { $between }, their radii add up to { $radii }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-parts = the { $operation } { $id } is empty: the { $one } { $one-id } lies apart from all parts of the { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-both = the { $operation } { $id } is empty: nothing is both inside and outside of the { $one } { $one-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-beyond = the { $operation } { $id } is empty: the { $one } { $one-id } lies outside of the { $two } { $two-id }
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-within = the { $operation } { $id } is empty: the { $one } { $one-id } lies within the { $two } { $two-id }, which is taken away
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-same = the { $operation } { $id } is empty: the { $one } { $one-id } and the { $two } { $two-id }, which is taken away, are the same
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }
W319-itself = the { $operation } { $id } is empty: the { $one } { $one-id } is taken away from itself
    .label = { W319.label }
    .one = { W319.one }
    .two = { W319.two }
    .note = { W319.note }

W320 = the profile of the { $type } { $id } crosses itself near x = { $x }, y = { $y }
    .label = { $one ->
        [start] the disc that closes the first point
        [end] the disc that closes the last point
       *[piece] the piece from point { $one-from } to { $one-to }
    }
    .other = { $two ->
        [start] the disc that closes the first point
        [end] the disc that closes the last point
       *[piece] the piece from point { $two-from } to { $two-to }
    }
    .note = what the profile goes around twice is outside, by the even-odd rule: a hollow within
    .help = are two points of the profile in the wrong order?
W320-torus = the torus { $id } runs through itself: its tube (r = { $tube }) is wider than its ring (R = { $ring })
    .label = r, the radius of the tube
    .ring = R, from the axis to the middle of the tube
    .note = where the tube overlaps itself, a lemon around the axis, is outside: a hollow within
    .fix = swap R and r

W321 = in the { $operation } { $id }, { W321.the-tool } ends flush with { W321.the-other }: they share a face around ({ $x }, { $y }, { $z })
    .label = { $tool-face ->
        [side] the face at { $tool-name }
        [boundary] its boundary
        [base] its base
        [mantle] its side
        [disc] the disc that closes this end
        [piece] this piece
       *[all] its surface
    }
    .other = { $other-face ->
        [side] the face at { $other-name }
        [boundary] its boundary
        [base] its base
        [mantle] its side
        [disc] the disc that closes this end
        [piece] this piece
       *[all] its surface
    }
    .operation = the { $operation }
    .note = whether a skin of no thickness is left there is up to rounding
    .help = let the tool reach a little past the face that it cuts through
    .fix = let it reach a hair further
    .the-tool = { $tool-copy ->
        [none] the { $tool } { $tool-id }{ $tool-in ->
            [none] {""}
           *[other] {" "}in { $tool-in }
        }
       *[other] the { $tool } { $tool-id } in the copy { $tool-copy }
    }
    .the-other = { $other-copy ->
        [none] the { $other } { $other-id }{ $other-in ->
            [none] {""}
           *[other] {" "}in { $other-in }
        }
       *[other] the { $other } { $other-id } in the copy { $other-copy }
    }
W321-round = { W321 }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321.note }
    .help = make the tool a little larger there than what it cuts, or write both alike: equal shapes in one place are decided exactly
    .fix = { W321.fix }
W321-holes = in the { $operation } { $id }, { W321.the-tool } cuts up to where { W321.the-other } does: they share a face around ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = whether a wall of no thickness is left between the two is up to rounding
    .help = let one of the two reach a little into the other
    .fix = { W321.fix }
W321-touch = in the { $operation } { $id }, { W321.the-tool } and { W321.the-other } only touch: they share a face around ({ $x }, { $y }, { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = what they have in common there is a sheet of no thickness; whether it is seen is up to rounding

W322 = the { $type } { $id } is ill-scaled: { $large } is { $large-size }, { $small } only { $small-size }
    .label = lengths that differ by more than 1e8
    .note = sixteen digits are too few for both: hits on the small parts are off by a good part of their size, and edges come out ragged
    .help = bring the sizes nearer together, or move the object nearer to the origin
W322-moved = the { $type } { $id }, as it is moved and stretched, is ill-scaled: { $large } is { $large-size }, { $small } only { $small-size }
    .label = { W322.label }
    .note = { W322.note }
    .help = { W322.help }
W322-stretched = the { $type } { $id }, as it is moved and stretched, is ill-scaled: { $large } along its { $large-axis } axis is { $large-size }, { $small } along its { $small-axis } axis only { $small-size }
    .label = { W322.label }
    .note = { W322.note }
    .help = { W322.help }

## Notes and style

N602 = there is no camera; the scene is framed automatically
    .help = a camera is written `ID -501 x y z dx dy dz ux uy uz fovy`

N603 = there is no light; a headlight of intensity 1 shines at the camera
    .help = a point light is written `ID -402 intensity` and moved with `ID -1 x y z`

S501 = `{ $text }` is notation; a scene needs none
    .label = read as white space
    .fix = { $count ->
        [one] remove it
       *[other] remove all { $count } on this line
    }

S502 = a comment of its own is introduced by `0`
    .fix = put `0` in front

S503 = { $count ->
    [one] a second record on the same line
   *[other] { $count } more records on the same line
}
    .fix = one record a line

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
    .help = what is all right is written `# zpg: allow(W307) #`, with codes or names
S504-empty = an entry of this comment is empty
    .help = what is all right is written `# zpg: allow(W307) #`, with codes or names
S504-no-code = { $count ->
    [one] there is no code { $text }
   *[other] there are no codes { $text }
}
    .help = `zpg explain` lists all codes
S504-error = { $count ->
    [one] an error, { $code }, cannot be allowed
   *[other] errors cannot be allowed: { $code }
}
