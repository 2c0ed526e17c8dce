S501 = `{ $text }` does not belong in a scene; numbers are separated by spaces
    .label = read as white space
    .points = write a decimal point
    .fix = { $count ->
        [one] remove it
       *[other] remove all { $count } on this line
    }
S501-decimal = { $text } is read as two numbers, { $number }
    .label = a decimal comma?
    .help = if it is one number, write it with a decimal point; the record then lacks a number
    .fix = write two numbers
