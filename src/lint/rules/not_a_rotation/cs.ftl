W303 = tato matice není rotace: { $deeds }
    .label = použije se tak, jak je
    .help = k záměrnému zvětšení nebo zrcadlení použijte typ -3
    .fix = napsat nejbližší rotaci
    .mirrors = zrcadlí
    .scales = její sloupce mají délky { $x }; { $y } a { $z }, ne 1
    .skews = její sloupce nejsou na sebe kolmé
    .rounded = její čísla se liší o více než 1e-6
