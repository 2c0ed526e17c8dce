W311 = obalový kvádr objektu { $id } je příliš malý: ({ $x }; { $y }; { $z }) je bod povrchu objektu
    .label = tento kvádr má obsahovat celý objekt
    .note = obrázek zůstane stejný, ale program, který kvádru věří, vynechá vše, co leží vně
    .fix = zvětšit ho
W311-sphere = obalová koule objektu { $id } je příliš malá: ({ $x }; { $y }; { $z }) je bod povrchu objektu
    .label = tato koule má obsahovat celý objekt
    .note = obrázek zůstane stejný, ale program, který kouli věří, vynechá vše, co leží vně
    .fix = zvětšit ji
