N607 = otočení o `{ $angle }` stupně vypadá jako úhel v radiánech: `{ $angle }` rad = { $degrees }°
    .label = úhel se píše ve stupních
    .note = takto se { $type } téměř neotočí
    .fix = napsat `{ $degrees }`
