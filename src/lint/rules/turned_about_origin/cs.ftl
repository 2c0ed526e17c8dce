N609 = rotace otáčí kolem počátku: { $type } { $id } se dostane z { $from } do { $to }
    .label = otočí objekt i jeho polohu
    .move = nejdřív se posune
    .help = má-li se otočit na místě, patří rotace před posunutí
    .fix = prohodit oba řádky: nejdřív otočit, potom posunout
