W316 = { $count ->
    [one] je tu { $count } kamera a není vybrána
    [few] jsou tu { $count } kamery a žádná není vybrána
   *[other] je tu { $count } kamer a žádná není vybrána
}: obrázek pořídí poslední z nich, { $id }
    .label = tato se použije
    .unused = { $other } se nepoužije
    .help = jednu lze vybrat pomocí `ID -502 KAMERA`, dvojici pro stereoskopický obrázek pomocí `ID -503 LEVÁ PRAVÁ`
    .fix = vybrat { $id }
