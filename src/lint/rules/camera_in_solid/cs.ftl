W325 = kamera { $id } je uvnitř objektu, který nepropouští světlo: { $solid } { $solid-id }
    .label = zde je kamera
    .solid = kamera je uvnitř tohoto objektu
    .note = kamera vidí jen povrch tělesa zevnitř
    .help = přesuňte kameru ven, nebo nechte těleso propouštět světlo optickou vlastností s kt > 0
