W343 = the rectangle { $id } is a floor by its comment, and stands upright
    .label = it is in the plane z = 0, and nothing rotates it
    .help = a rectangle has bounds in x and y: a rotation about the axis x lays it down
    .fix = lay it down: add `{ $line }`
