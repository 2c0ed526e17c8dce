N606 = { $percent } % obrázku je jasnější než bílá
    .light = { $light } { $id } má největší intenzitu
    .help = ztmaví ho slabší světla nebo `zpg render --exposure`
