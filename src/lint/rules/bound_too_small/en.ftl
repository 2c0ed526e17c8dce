W311 = the bounding box of the object { $id } is too small: ({ $x }, { $y }, { $z }) is a point of its surface
    .label = this box should hold the object
    .note = the picture is the same, but a program that trusts the box leaves out what lies outside
    .fix = enlarge it
W311-sphere = the bounding sphere of the object { $id } is too small: ({ $x }, { $y }, { $z }) is a point of its surface
    .label = this sphere should hold the object
    .note = the picture is the same, but a program that trusts the sphere leaves out what lies outside
    .fix = { W311.fix }
