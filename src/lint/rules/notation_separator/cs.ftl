S501 = `{ $text }` do scény nepatří; čísla se oddělují mezerami
    .label = čteno jako mezera
    .fix = { $count ->
        [one] odstranit
       *[other] odstranit všechny na tomto řádku ({ $count })
    }
