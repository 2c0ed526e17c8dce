W324 = nic nebude vidět: vše, co se vykresluje, leží { $where ->
        [behind] za kamerou { $id }
        [left] vlevo od toho, co vidí kamera { $id }
        [right] vpravo od toho, co vidí kamera { $id }
        [above] nad tím, co vidí kamera { $id }
        [below] pod tím, co vidí kamera { $id }
       *[beside] mimo to, co vidí kamera { $id }
    }
    .label = sem kamera hledí
    .note = v obrázku o velikosti { $width } × { $height } pixelů
    .help = přesuňte kameru, nebo ji otočte k tomu, co se vykresluje
    .fix = otočit kameru do středu toho, co se vykresluje
    .fix-sign = napsat { $number }, s opačným znaménkem
W324-unbounded = kamera { $id } neuvidí nic kromě toho, co nemá konec (například podlahy)
    .label = { W324.label }
    .note = { W324.note }
    .help = { W324.help }
    .fix = { W324.fix }
    .fix-sign = { W324.fix-sign }
W324-unbounded-elsewhere = { W324-unbounded }
    .label = { W324.label }
    .note = { W324.note }
    .help = přesuňte kameru, nebo ji otočte: střed toho, co má konec, leží od ní ve směru { $way }
