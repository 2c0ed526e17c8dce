S501 = `{ $text }` does not belong in a scene; numbers are separated by spaces
    .label = read as white space
    .fix = { $count ->
        [one] remove it
       *[other] remove all { $count } on this line
    }
