W340 = the difference { $id } is { $one } without { $two }, and its comment says the reverse
    .label = the second operand is taken from the first
    .help = name first what remains
    .fix = write { $number }
W340-taken = the difference { $id } is { $one } without { $two }, and a comment says that { $one } is taken away
    .label = { W340.label }
    .help = { W340.help }
    .fix = { W340.fix }
