sum-in-red = kd + ks + kt = { $red } v červené složce
sum-in-green = kd + ks + kt = { $green } v zelené složce
sum-in-blue = kd + ks + kt = { $blue } v modré složce
W302 = tento povrch vydává více světla, než dostává: `kd + ks + kt = { $sum }`
    .label = více než 1
    .help = difuzní, zrcadlová a propuštěná část se dělí o dopadající světlo; jejich součet má být nejvýše 1
    .fix = vydělit části jejich součtem
    .point-lost = napsat desetinnou tečku
    .kinds = seřadit části podle barev: kd ks kt pro červenou, pak zelenou, pak modrou
W302-red = { W302 } v červené složce
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
W302-green = { W302 } v zelené složce
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
W302-blue = { W302 } v modré složce
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
