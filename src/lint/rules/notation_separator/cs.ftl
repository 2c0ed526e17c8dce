S501 = `{ $text }` do scény nepatří; čísla se oddělují mezerami
    .label = čteno jako mezera
    .points = napsat desetinnou tečku
    .fix = { $count ->
        [one] odstranit
       *[other] odstranit všechny na tomto řádku ({ $count })
    }
S501-decimal = { $text } je čteno jako dvě čísla, { $number }
    .label = desetinná čárka?
    .help = je-li to jedno číslo, patří do něj desetinná tečka; záznamu pak číslo chybí
    .fix = zapsat dvě čísla
