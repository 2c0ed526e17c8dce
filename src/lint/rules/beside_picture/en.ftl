N608 = the { $object } { $object-id } is not in the picture: it lies { $where ->
        [behind] behind the camera { $camera }
        [left] to the left of what the camera { $camera } sees
        [right] to the right of what the camera { $camera } sees
        [above] above what the camera { $camera } sees
        [below] below what the camera { $camera } sees
       *[beside] beside what the camera { $camera } sees
    }
    .label = this puts it there
    .note = in a picture of { $width } by { $height } pixels
    .fix-decimal = write { $number }, with a decimal point
    .fix-sign = write { $number }, with the other sign
