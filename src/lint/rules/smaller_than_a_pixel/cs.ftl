W329 = vše, co se kreslí, je menší než pixel: kamera { $id } to vidí nejvýše { $size } pixelu široké a vysoké
    .label = při pohledu odtud
    .note = v obraze o { $width } krát { $height } pixelech
    .help = přibližte kameru, zmenšete zorný úhel, nebo zvětšete objekty
