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
    .note = by the even-odd rule, what the profile goes around twice is outside: the object is hollow there
    .help = are two points of the profile in the wrong order?
W320-mended = { W320 }
    .label = { W320.label }
    .other = { W320.other }
    .note = { W320.note }
    .fix-point = if { $old } has lost its decimal point, write { $number }
    .fix-pairs = if the height stands before the radius, swap the numbers of each point
    .help = { W320.help }
W320-torus = the torus { $id } runs through itself: its tube (r = { $tube }) is wider than its ring (R = { $ring })
    .label = r, the radius of the tube
    .ring = R, from the axis to the middle of the tube
    .note = where the tube overlaps itself, a lemon around the axis, is outside: the torus is hollow there
    .fix = swap R and r
