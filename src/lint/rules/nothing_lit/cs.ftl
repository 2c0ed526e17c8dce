W330 = vše, co vidí kamera { $id }, je černé: nedopadá na to žádné světlo
    .label = světlo odtud nedopadne na to, co kamera vidí
    .camera = kamera
    .note = zjištěno z obrázku o velikosti { $width } × { $height } pixelů
    .help = přesuňte světlo na stranu kamery, nebo přidejte ambientní světlo (-401)
