N606 = { $percent } % of the picture is brighter than white
    .help = weaker lights make it darker, and so does `zpg render --exposure`
