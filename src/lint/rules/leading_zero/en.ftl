S505 = { $text } begins with a zero: is its decimal point missing?
    .label = read as { $value }
    .fix = write { $number }
