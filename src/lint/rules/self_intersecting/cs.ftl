W320 = { $type } { $id }: profil protíná sám sebe poblíž bodu ({ $x }; { $y })
    .label = { $one ->
        [start] kruh, který uzavírá první bod
        [end] kruh, který uzavírá poslední bod
       *[piece] úsek z bodu { $one-from } do bodu { $one-to }
    }
    .other = { $two ->
        [start] kruh, který uzavírá první bod
        [end] kruh, který uzavírá poslední bod
       *[piece] úsek z bodu { $two-from } do bodu { $two-to }
    }
    .note = co profil obíhá dvakrát, je podle pravidla sudá–lichá venku: uvnitř je dutina
    .help = nejsou dva body profilu v opačném pořadí?
W320-mended = { W320 }
    .label = { W320.label }
    .other = { W320.other }
    .note = { W320.note }
    .fix-point = ztratilo-li { $old } desetinnou tečku, napsat { $number }
    .fix-pairs = stojí-li výška před poloměrem, prohodit čísla každého bodu
    .help = { W320.help }
W320-torus = torus { $id } prochází sám sebou: trubka (`r = { $tube }`) je širší než prstenec (`R = { $ring }`)
    .label = r, poloměr trubky
    .ring = R, od osy do středu trubky
    .note = místo kolem osy, kde se trubka překrývá sama se sebou, už k tělesu nepatří: uvnitř je dutina
    .fix = prohodit R a r
