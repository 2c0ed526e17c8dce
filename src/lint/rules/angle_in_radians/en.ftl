W323 = an angle of view of { $angle } degrees looks like { $about }° in radians
    .label = this is in degrees
    .note = as it is, the picture shows a tiny part of the scene only
    .fix = write `{ $degrees }`
W323-unusual = an angle of view of { $angle }° is very small; in radians it would be { $about }°
    .label = this is in degrees
    .note = as it is, the picture shows a tiny part of the scene only
    .fix = write `{ $degrees }`
