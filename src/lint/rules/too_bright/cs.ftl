N606 = { $percent } % obrázku je jasnějších než bílá
    .help = ztmaví ho slabší světla nebo `zpg render --exposure`
