W313 = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: průnik { $id } z ní
   *[part] obsahuje plochu bez vnitřku: průnik { $id } z ní
} ponechá to, co je uvnitř ({ $other } { $other-id })
    .label = tento operand
    .surface = { $shape } { $shape-id } je plocha: nemá vnitřek
    .help = operace jsou určeny pro tělesa: místo roviny (typ 3) lze použít poloprostor (typ 4), místo obdélníku tenký kvádr
W313-outside = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: rozdíl { $id } z ní
   *[part] obsahuje plochu bez vnitřku: rozdíl { $id } z ní
} ponechá to, co je venku ({ $other } { $other-id })
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-tool = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: jejím
   *[part] obsahuje plochu bez vnitřku: jejím
} odečtením se nic nezmění ({ $other } { $other-id })
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-both = { $operand } { $operand-id } a { $other } { $other-id } jsou plochy bez vnitřku: jejich průnik { $id } je prázdný
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
W313-complement = { $operand } { $operand-id } { $what ->
    [whole] je plocha bez vnitřku: jejím doplňkem { $id } je celý prostor
   *[part] obsahuje plochu bez vnitřku: doplněk { $id } k ní nepřihlíží
}
    .label = { W313.label }
    .surface = { W313.surface }
    .help = { W313.help }
