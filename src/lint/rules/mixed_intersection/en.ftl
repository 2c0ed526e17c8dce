W308 = the intersection { $id } keeps two looks: the { $first } { $first-id } and the { $second } { $second-id } differ in { $aspects ->
    [texture] colour
    [optics] optical property
    [index] refractive index
    [texture-optics] colour and optical property
    [texture-index] colour and refractive index
    [optics-index] optical property and refractive index
   *[all] colour, optical property and refractive index
}
    .label = nothing is assigned to { $id }
    .note = every piece of its surface has the properties of the operand that it comes from
    .help = if it is meant to look the same all over, assign properties to the result: `{ $id } -299 TEXTURE OPTICS`
    .fix = give { $id } the properties of { $source }
