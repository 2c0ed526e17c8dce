W335 = { $object } { $object-id } není nikdy vidět: celý objekt leží uvnitř neprůhledného tělesa: { $solid } { $solid-id }
    .label = toto je celé skryté
    .solid = tímto tělesem, které nepropouští světlo
    .help = nemá to být rozdíl? Díra se píše `-103 { $solid-id } { $object-id }`
W335-on-top = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .fix-on-top = má-li ležet nahoře, napsat { $number }
    .note = má-li to být díra, je to rozdíl: `-103 { $solid-id } { $object-id }`
W335-several = { $count ->
    [one] { $count } objekt není
    [few] { $count } objekty nejsou
   *[other] { $count } objektů není
} nikdy vidět: vše leží uvnitř neprůhledného tělesa: { $solid } { $solid-id }
    .label = první z nich
    .solid = { W335.solid }
    .help = { W335.help }
W335-half-space = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .help = posuňte ho ven, nebo opravte poloprostor: jeho vnitřek je ax + by + cz + d ≤ 0
    .fix-move = { W325-half-space.fix-move }
W335-half-space-several = { W335-several }
    .label = { W335-several.label }
    .solid = { W335.solid }
    .help = vnitřek poloprostoru je ax + by + cz + d ≤ 0: zkontrolujte jeho normálu a znaménko d
    .fix-move = { W335-half-space.fix-move }
W335-half-space-order = { W335 }
    .label = { W335.label }
    .solid = { W335.solid }
    .help = rotace otáčí kolem počátku i to, co už je posunuté: otočte objekt dřív, než se posune
    .fix-order = prohodit oba řádky: nejdřív otočit, potom posunout
    .fix-move = { W335-half-space.fix-move }
W335-plane = { $object } { $object-id } není z žádné kamery vidět: v cestě je rovina { $solid-id }
    .label = { W335.label }
    .solid = kamery jsou na jedné straně této roviny, objekt na druhé
    .help = posuňte rovinu nebo objekt: rovina je tam, kde ax + by + cz + d = 0
    .fix-move = { W335-half-space.fix-move }
W335-plane-several = { $count ->
    [one] { $count } objekt není
    [few] { $count } objekty nejsou
   *[other] { $count } objektů není
} z žádné kamery vidět: v cestě je rovina { $solid-id }
    .label = { W335-several.label }
    .solid = kamery jsou na jedné straně této roviny, objekty na druhé
    .help = rovina je tam, kde ax + by + cz + d = 0: zkontrolujte její normálu a znaménko d
    .fix-move = { W335-half-space.fix-move }
