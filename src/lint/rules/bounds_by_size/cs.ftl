W341 = { $type } { $id }: komentář mluví o velikosti, ale čísla se čtou jako meze
    .label = toto jsou horní meze
    .help = nejdřív jsou dolní meze, potom horní: z obou zpg pozná místo i velikost
    .fix-size = { E202.fix-size }
    .fix-centre = { E202.fix-centre }
    .fix-half = { E202.fix-half }
