W343 = the comment calls the rectangle { $id } a floor, but it stands upright
    .label = it is in the plane z = 0, and nothing rotates it
    .help = a rectangle has bounds in x and y: a rotation about the axis x lays it down
    .fix = lay it down: add `{ $line }`
