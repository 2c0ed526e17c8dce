W318 = this refractive index has no effect: no light goes through the { $object } { $object-id }
    .label = kt is 0 wherever this index counts
    .help = light is refracted where a part of it is transmitted: give it an optical property with kt > 0, such as `{ $object-id } -201 0 0.1 0.9`
W318-below-one = a refractive index is at least 1, that of a vacuum; here { $parts }
    .label = less than 1
    .help = the index is that of the object's own material; what surrounds it counts by itself
