W326 = bodové světlo { $id } je uvnitř objektu, který nepropouští světlo, a venku nic neosvětluje: { $solid } { $solid-id }
    .label = toto světlo
    .solid = světlo je uvnitř tohoto objektu
    .help = přesuňte světlo ven, nebo nechte těleso propouštět světlo optickou vlastností s kt > 0
W326-surface = bodové světlo { $id } leží na povrchu objektu a povrch kolem sebe neosvětluje: { $solid } { $solid-id }
    .label = toto světlo
    .solid = světlo leží na povrchu tohoto objektu
    .help = odsuňte světlo od povrchu
