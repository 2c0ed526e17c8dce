W337 = { $object } { $object-id } není vůbec vidět: propouští všechno světlo a neláme je
    .label = žádné světlo se tu neodráží ani neztrácí
    .help = sklo má index lomu: `{ $line }`
    .fix = přidat index lomu skla
W337-several = { $count ->
    [one] { $count } objekt není vůbec vidět
    [few] { $count } objekty nejsou vůbec vidět
   *[other] { $count } objektů není vůbec vidět
}: všechno světlo prochází a neláme se
    .label = první z nich: žádné světlo se tu neodráží ani neztrácí
    .help = { W337.help }
    .fix = přidat všem index lomu skla
