W321 = { $operation } { $id }: { W321.the-tool } končí přesně na povrchu, který má { W321.the-other }: mají společnou stěnu kolem ({ $x }; { $y }; { $z })
    .label = { $tool-face ->
        [side] stěna { $tool-name }
        [boundary] hraniční rovina
        [base] podstava
        [mantle] plášť
        [disc] kruh, který uzavírá tento konec
        [piece] tento úsek
       *[all] povrch
    }
    .other = { $other-face ->
        [side] stěna { $other-name }
        [boundary] hraniční rovina
        [base] podstava
        [mantle] plášť
        [disc] kruh, který uzavírá tento konec
        [piece] tento úsek
       *[all] povrch
    }
    .operation = { $operation }
    .note = zda tam zbude stěna nulové tloušťky, záleží na zaokrouhlení
    .help = protáhněte odečítané těleso o kousek za stěnu, kterou prořezává
    .fix = protáhnout odečítané těleso o kousek dál
    .the-tool = { $tool-copy ->
        [none] { $tool } { $tool-id }{ $tool-in ->
            [none] {""}
           *[other] {" "}v { $tool-in }
        }
       *[other] { $tool } { $tool-id } v kopii { $tool-copy }
    }
    .the-other = { $other-copy ->
        [none] { $other } { $other-id }{ $other-in ->
            [none] {""}
           *[other] {" "}v { $other-in }
        }
       *[other] { $other } { $other-id } v kopii { $other-copy }
    }
W321-round = { W321 }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321.note }
    .help = zvětšete tam odečítané těleso tak, aby o kousek přesahovalo to, co řeže, nebo zapište oba tvary stejně: o stejných tvarech na jednom místě se rozhoduje přesně
    .fix = { W321.fix }
W321-holes = { $operation } { $id }: { W321.the-tool } řeže až tam, kam { W321.the-other }: mají společnou stěnu kolem ({ $x }; { $y }; { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = zda mezi nimi zbude stěna nulové tloušťky, záleží na zaokrouhlení
    .help = protáhněte jedno z odečítaných těles o kousek do druhého
    .fix = { W321.fix }
W321-touch = { $operation } { $id }: { W321.the-tool } a { W321.the-other } se jen dotýkají: mají společnou stěnu kolem ({ $x }; { $y }; { $z })
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = společnou mají jen stěnu nulové tloušťky; zda je vidět, záleží na zaokrouhlení
W321-empty = { W321-touch }
    .label = { W321.label }
    .other = { W321.other }
    .operation = { W321.operation }
    .note = { W321-touch.note }
    .help = jinak je průnik prázdný: nemělo to být sjednocení?
    .fix-union = má-li to být sjednocení, napsat { $number }
