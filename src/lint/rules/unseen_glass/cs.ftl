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
W337-called = { $object } { $object-id }: podle komentáře sklo, voda nebo diamant, ale světlo neláme
    .label = k tomu není žádný index lomu
    .help = bez záznamu -203 je index lomu 1
    .fix = přidat index lomu: `{ $line }`
W337-called-several = podle komentářů { $count ->
    [one] { $count } objekt je sklo, voda nebo diamant, ale světlo neláme
    [few] { $count } objekty jsou sklo, voda nebo diamant, ale světlo nelámou
   *[other] { $count } objektů je sklo, voda nebo diamant, ale světlo neláme
}
    .label = první z nich: k tomu není žádný index lomu
    .help = { W337-called.help }
    .fix = přidat všem index lomu, třeba `{ $line }`
W337-unlike = { $object } { $object-id } propouští světlo a neláme je, { $other } { $other-id } ho láme
    .label = k tomu není žádný index lomu
    .other = tento objekt index lomu má
    .help = bez záznamu -203 je index lomu 1
    .fix = přidat stejný index lomu: `{ $line }`
W337-unlike-several = { $count ->
    [one] { $count } objekt propouští světlo a neláme
    [few] { $count } objekty propouštějí světlo a nelámou
   *[other] { $count } objektů propouští světlo a neláme
} je; { $other } { $other-id } ho láme
    .label = první z nich: k tomu není žádný index lomu
    .other = { W337-unlike.other }
    .help = { W337-unlike.help }
    .fix = přidat všem stejný index lomu
