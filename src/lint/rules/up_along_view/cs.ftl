W328 = vektor „nahoru“ kamery { $id } míří téměř ve směru pohledu: úhel je { $angle }°
    .label = o tom, kde je nahoře, rozhodují poslední číslice
    .help = míří-li kamera přímo nahoru nebo dolů, zvolte `0 0 1` nebo `0 0 -1`
    .fix = napsat vektor „nahoru“ `{ $up }`, s nímž je nahoře totéž
