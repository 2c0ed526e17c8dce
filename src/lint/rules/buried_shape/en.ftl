W335 = the { $object } { $object-id } is never seen: all of it lies inside of the opaque { $solid } { $solid-id }
    .label = all of this is hidden
    .solid = by this, which lets no light through
    .help = did you mean a difference? To cut a hole, write `-103 { $solid-id } { $object-id }`
W335-on-top = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .fix-on-top = to put it on top, write { $number }
    .note = if a hole is meant, it is a difference: `-103 { $solid-id } { $object-id }`
W335-several = { $count ->
    [one] one object is
   *[other] { $count } objects are
} never seen: all of this lies inside of the opaque { $solid } { $solid-id }
    .label = the first of them
    .solid = { W335.solid }
    .help = did you mean a difference? To cut a hole, write `-103 { $solid-id } { $object-id }`
W335-half-space = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .help = move the { $object } out of it, or correct the half-space: its inside is ax + by + cz + d ≤ 0
    .fix-move = { W325-half-space.fix-move }
W335-half-space-several = { W335-several }
    .label = { W335-several.label }
    .solid = { W335.solid }
    .help = the inside of a half-space is ax + by + cz + d ≤ 0: look at its normal and at the sign of d
    .fix-move = { W335-half-space.fix-move }
W335-half-space-order = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .help = a rotation turns about the origin and carries along what was moved before: turn the { $object } before it is moved
    .fix-order = swap the two lines: turn it first, then move it
    .fix-move = { W335-half-space.fix-move }
W335-plane = no camera sees the { $object } { $object-id }: the plane { $solid-id } lies between them
    .label = { W335.label }
    .solid = the cameras are on one side of this, the { $object } is on the other
    .help = move the plane or the { $object }: the plane is where ax + by + cz + d = 0
    .fix-move = { W335-half-space.fix-move }
W335-plane-several = no camera sees { $count ->
    [one] one object
   *[other] { $count } objects
}: the plane { $solid-id } lies in between
    .label = { W335-several.label }
    .solid = the cameras are on one side of this, the objects are on the other
    .help = a plane is where ax + by + cz + d = 0: look at its normal and at the sign of d
    .fix-move = { W335-half-space.fix-move }
