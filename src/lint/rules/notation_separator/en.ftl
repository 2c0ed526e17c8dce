S501 = `{ $text }` is notation; a scene needs none
    .label = read as white space
    .fix = { $count ->
        [one] remove it
       *[other] remove all { $count } on this line
    }
