sum-in-red = kd + ks + kt = { $red } in red
sum-in-green = kd + ks + kt = { $green } in green
sum-in-blue = kd + ks + kt = { $blue } in blue
W302 = this surface gives off more light than it gets: kd + ks + kt = { $sum }
    .label = more than 1
    .help = the three parts share the light that arrives; their sum should be at most 1
    .fix = divide the parts by their sum
    .point-lost = write the decimal point
    .kinds = order the parts by colour: kd ks kt of red, then of green, then of blue
W302-red = { W302 } in red
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
W302-green = { W302 } in green
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
W302-blue = { W302 } in blue
    .label = { W302.label }
    .help = { W302.help }
    .fix = { W302.fix }
    .point-lost = { W302.point-lost }
    .kinds = { W302.kinds }
