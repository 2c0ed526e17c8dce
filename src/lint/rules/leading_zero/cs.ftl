S505 = { $text } začíná nulou: nechybí tu desetinná tečka?
    .label = čteno jako { $value }
    .fix = napsat { $number }
