N607 = a rotation by { $angle } degrees looks like radians: { $angle } rad = { $degrees }°
    .label = this is in degrees
    .note = as it is, the { $type } hardly turns
    .fix = write `{ $degrees }`
