W336 = { $type } pro { $id } tu stojí podruhé
    .label = změní objekt ještě jednou
    .first = poprvé
    .help = jeden z obou záznamů odstraňte; platí-li oba, řekne to komentář mezi nimi
    .fix = odstranit druhý záznam
