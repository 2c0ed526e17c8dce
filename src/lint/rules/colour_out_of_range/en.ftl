W301 = the parts of a colour must lie between 0 and 1; here { $parts }
    .label = used as it is
    .note = a part above 1 makes a surface brighter than the light that falls on it, a negative one takes light away; to make a light brighter, raise its intensity
    .bytes = these look like numbers from 0 to 255, which are sRGB as in other programs; the colours of a scene are linear
    .linear = write these sRGB numbers as linear ones
    .hundredths = divide by 100
    .shares = divide by 255
    .point-lost = write the decimal point
    .fix = write the nearest colour that is in range
W301-point = the parts of a colour must lie between 0 and 1; at profile point { $point }, { $parts }{ $others ->
    [0] {""}
    [one] , and { $others } more colour is out of range
   *[other] , and { $others } more colours are out of range
}
    .label = { W301.label }
    .note = { W301.note }
    .bytes = { W301.bytes }
    .linear = { W301.linear }
    .hundredths = { W301.hundredths }
    .shares = { W301.shares }
    .point-lost = { W301.point-lost }
    .fix = { W301.fix }
