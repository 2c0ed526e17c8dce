W328 = the up vector of the camera { $id } is nearly along its view direction: the angle is { $angle }°
    .label = so that the last digits decide which way is up
    .help = for a camera that looks straight up or down take `0 0 1` or `0 0 -1`
    .fix = write the up vector `{ $up }`, which has the same way up
W328-turned = the picture is turned: y is up in zpg, and the camera { $id } has z up
    .label = the floor and the lamps say that y is up
    .fix = write the up vector `0 1 0`
