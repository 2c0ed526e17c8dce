W324 = nic nebude vidět: vše, co se kreslí, leží { $where ->
        [behind] za kamerou { $id }
        [left] vlevo od toho, co vidí kamera { $id }
        [right] vpravo od toho, co vidí kamera { $id }
        [above] nad tím, co vidí kamera { $id }
        [below] pod tím, co vidí kamera { $id }
       *[beside] mimo to, co vidí kamera { $id }
    }
    .label = sem kamera hledí
    .note = v obraze o { $width } krát { $height } pixelech
    .help = přesuňte kameru, nebo ji otočte k tomu, co se kreslí
    .fix = pohled do středu toho, co se kreslí
