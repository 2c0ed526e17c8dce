N607 = a rotation by { $angle } degrees looks like radians: { $angle } rad = { $degrees }°
    .label = this is in degrees
    .note = as it is, what is rotated hardly turns
    .fix = write { $degrees }
