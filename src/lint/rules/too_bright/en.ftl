N606 = { $percent } % of the picture is brighter than white
    .light = the { $light } { $id } has the greatest intensity
    .help = weaker lights make it darker, and so does `zpg render --exposure`
