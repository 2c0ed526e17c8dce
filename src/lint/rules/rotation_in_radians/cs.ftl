N607 = otočení o `{ $angle }` stupně vypadá jako úhel v radiánech: `{ $angle }` rad = { $degrees }°
    .label = úhel se píše ve stupních
    .note = { $type } se tak skoro neotočí
    .fix = napsat `{ $degrees }`
