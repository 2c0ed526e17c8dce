W328 = vektor „nahoru“ kamery { $id } míří téměř ve směru pohledu: úhel je { $angle }°
    .label = o tom, kde je nahoře, rozhodují poslední číslice
    .help = míří-li kamera přímo nahoru nebo dolů, zvolte `0 0 1` nebo `0 0 -1`
    .fix = napsat vektor „nahoru“ `{ $up }`, s nímž je nahoře totéž
W328-turned = obrázek je otočený: v zpg míří nahoru osa y, ale kamera { $id } má nahoře osu z
    .label = podle podlahy a světel je nahoře osa y
    .fix = napsat vektor „nahoru“ `0 1 0`
