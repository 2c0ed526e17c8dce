W325 = the camera { $id } is inside of the { $solid } { $solid-id }, which lets no light through
    .label = this place is inside
    .solid = of this
    .note = all that it sees is the surface of the solid from inside
    .help = move the camera out, or let light through the solid with an optical property with kt > 0
