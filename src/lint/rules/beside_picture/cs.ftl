N608 = { $object } { $object-id } není na obrázku: leží { $where ->
        [behind] za kamerou { $camera }
        [left] vlevo od toho, co vidí kamera { $camera }
        [right] vpravo od toho, co vidí kamera { $camera }
        [above] nad tím, co vidí kamera { $camera }
        [below] pod tím, co vidí kamera { $camera }
       *[beside] mimo to, co vidí kamera { $camera }
    }
    .label = toto určuje polohu
    .note = v obrázku o velikosti { $width } × { $height } pixelů
    .fix-decimal = napsat { $number }, s desetinnou tečkou
    .fix-sign = napsat { $number }, s opačným znaménkem
