W326 = the point light { $id } is inside of the { $solid } { $solid-id }, which lets no light through: it lights nothing outside
    .label = this light is inside
    .solid = of this
    .help = move the light out, or let light through the solid with an optical property with kt > 0
W326-surface = the point light { $id } lies on the surface of the { $solid } { $solid-id } and lights nothing of it nearby
    .label = this light is on the surface
    .solid = of this
    .help = move the light off the surface
