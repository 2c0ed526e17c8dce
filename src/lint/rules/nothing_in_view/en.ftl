W324 = nothing will be seen: all that is drawn lies { $where ->
        [behind] behind the camera { $id }
        [left] to the left of what the camera { $id } sees
        [right] to the right of what the camera { $id } sees
        [above] above what the camera { $id } sees
        [below] below what the camera { $id } sees
       *[beside] beside what the camera { $id } sees
    }
    .label = the camera looks this way
    .note = in a picture of { $width } by { $height } pixels
    .help = move the camera, or turn it to what is drawn
    .fix = look at the middle of what is drawn
    .fix-sign = write { $number }, with the other sign
W324-unbounded = the camera { $id } will see only objects that have no end, such as a floor
    .label = { W324.label }
    .note = { W324.note }
    .help = { W324.help }
    .fix = { W324.fix }
    .fix-sign = { W324.fix-sign }
W324-unbounded-elsewhere = { W324-unbounded }
    .label = { W324.label }
    .note = { W324.note }
    .help = move the camera, or turn it: the middle of the objects that have an end lies in the direction { $way } from the camera
