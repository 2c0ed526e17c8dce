W325 = kamera { $id } je uvnitř objektu, který nepropouští světlo: { $solid } { $solid-id }
    .label = toto místo je uvnitř
    .solid = tohoto objektu
    .note = kamera vidí jen povrch tohoto tělesa zevnitř
    .help = přesuňte kameru ven, nebo nechte těleso propouštět světlo optickou vlastností s kt > 0
