W303 = this matrix is not a rotation: { $deeds }
    .label = applied as it is given
    .help = for a scaling or a mirror image on purpose, use type -3
    .fix = write the nearest rotation
    .mirrors = it mirrors
    .scales = its columns have the lengths { $x }, { $y } and { $z }, not 1
    .skews = its columns are not at right angles
    .rounded = its entries are off by more than 1e-6
