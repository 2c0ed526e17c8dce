W326 = bodové světlo { $id } je uvnitř objektu, který nepropouští světlo, a venku nic neosvětluje: { $solid } { $solid-id }
    .label = toto světlo je uvnitř
    .solid = tohoto objektu
    .help = přesuňte světlo ven, nebo nechte těleso propouštět světlo optickou vlastností s kt > 0
W326-surface = bodové světlo { $id } leží na povrchu objektu a poblíž z něj nic neosvětluje: { $solid } { $solid-id }
    .label = toto světlo je na povrchu
    .solid = tohoto objektu
    .help = odsuňte světlo od povrchu
