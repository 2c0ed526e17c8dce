W330 = vše, co vidí kamera { $id }, je černé: nedopadá na to žádné světlo
    .label = světlo odtud tam nedopadne
    .camera = kamera
    .note = soudě podle obrázku o { $width } krát { $height } pixelech
    .help = přesuňte světlo na tu stranu, kde je kamera, nebo přidejte ambientní světlo (-401)
