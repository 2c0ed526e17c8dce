W329 = vše, co se vykresluje, je menší než pixel: pro kameru { $id } to má na šířku i na výšku nejvýše { $size } pixelu
    .label = při pohledu odtud
    .note = v obrázku o velikosti { $width } × { $height } pixelů
    .help = přibližte kameru, zmenšete zorný úhel, nebo zvětšete objekty
