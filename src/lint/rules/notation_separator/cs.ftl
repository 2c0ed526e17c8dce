S501 = `{ $text }` patří do popisu v tabulce; ve scéně se nepíše
    .label = čteno jako mezera
    .fix = { $count ->
        [one] odstranit
       *[other] odstranit všechny na tomto řádku ({ $count })
    }
