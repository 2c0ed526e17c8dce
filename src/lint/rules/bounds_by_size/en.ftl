W341 = a comment on the { $type } { $id } speaks of a size, and its numbers are read as bounds
    .label = these are the upper bounds
    .help = first come the lower bounds, then the upper ones: with both zpg knows place and size
    .fix-size = { E202.fix-size }
    .fix-centre = { E202.fix-centre }
    .fix-half = { E202.fix-half }
