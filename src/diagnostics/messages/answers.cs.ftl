### Co příkazy odpovídají lidem, česky.

## zpg plan

plan-on = ano
plan-off = ne
plan-because = řádek { $line }: { $id } { $text }
plan-shapes = tvary
plan-operations = operace
plan-count = { $count }× { $name }
plan-none = žádné
plan-media = vnořená prostředí
plan-not-drawn = nevykreslená ID
plan-nothing = žádná
plan-ids-more = { $ids } a dalších { $more }
plan-not-seen = není vidět
plan-part = řádek { $line }: { $id }, { $why }
plan-more = a dalších { $more }

## zpg render

progress-left = zbývá { $time }
cost-seconds = čtení { $load } · plán { $plan } · příprava { $build } · paprsky { $trace } · zápis { $encode }

## zpg crosscheck

crosscheck-answer = { $scene }{ $name }, { $with }, { $width }x{ $height }: { $answer }
crosscheck-agrees = souhlasí
crosscheck-agrees-in-part = souhlasí všude, kde se porovnávalo ({ $percent } %)
crosscheck-difference = rozdíl
crosscheck-legend-alike = shoda
crosscheck-legend-differing = rozdíl
crosscheck-legend-silhouettes = obrysy
crosscheck-legend-silhouettes-differ = jiné obrysy
crosscheck-legend-edges = další jiné hrany
crosscheck-legend-total-reflection = úplný odraz
crosscheck-legend-left-out = vynecháno
crosscheck-differs = LIŠÍ SE
crosscheck-cannot = NELZE POROVNAT
crosscheck-folder = Obrázky a čísla jsou ve složce { $folder }

## zpg sheet

sheet-pictures = { $count ->
    [one] { $count } obrázek
    [few] { $count } obrázky
   *[other] { $count } obrázků
}
sheet-clean = bez chyb a varování
sheet-scene-clean = v pořádku
sheet-no-picture = obrázek chybí
sheet-errors = { $count ->
    [one] { $count } chyba, proto obrázek chybí
    [few] { $count } chyby, proto obrázek chybí
   *[other] { $count } chyb, proto obrázek chybí
}
sheet-unreadable = obrázek nelze přečíst: { $reason }
sheet-more = { $count ->
    [one] a { $count } další
    [few] a { $count } další
   *[other] a { $count } dalších
}
crosscheck-off-silhouettes = mimo obrysy
crosscheck-where = nejvíc z nich
crosscheck-mostly = { $pixels } tam, kde je vidět { $what }, v řádcích { $first-row } až { $last-row } a sloupcích { $first-column } až { $last-column }
crosscheck-of-type = { $id } ({ $type })
crosscheck-background = pozadí
crosscheck-on-silhouettes = na obrysech
crosscheck-off-edges = mimo hrany
crosscheck-on-other-edges = na jiných hranách
crosscheck-silhouettes = obrysy
crosscheck-total-reflection = úplný odraz
crosscheck-flip = FLIP
crosscheck-povray-flip = { $flip } (od 0 do 1): jak velký rozdíl vnímá člověk
crosscheck-left-out = vynecháno
crosscheck-exact = přesné tvary
crosscheck-meshes = sítě
crosscheck-povray-off = pixelů, které se liší o víc než { $most }/255: { $pixels } ({ $percent } %); největší rozdíl je { $largest }/255, průměrný { $mean }/255
crosscheck-povray-on = pixelů, které se liší: { $pixels }
crosscheck-povray-edges = pixelů, které se liší tam, kde končí stěna, stín, vzor nebo to, co je vidět v zrcadle nebo ve skle: { $pixels }
crosscheck-povray-total = pixelů: { $pixels }; neporovnávají se, POV-Ray ho počítá jinak
crosscheck-mitsuba-off = jiný tvar, jinou polohu nebo jinou normálu ukazuje { $wrong } z { $pixels ->
    [one] { $pixels } pixelu
   *[other] { $pixels } pixelů
} ({ $percent } %)
crosscheck-mitsuba-silhouettes = pixelů na hranách tvarů a stěn: { $pixels }; ty se neporovnávají
crosscheck-mitsuba-cut = pixelů, kde jsou nekonečné části v převodu uříznuté: { $pixels }
crosscheck-mitsuba-undecided = pixelů, kde jednoduchá přesnost, ve které Mitsuba počítá, vidí něco jiného: { $pixels }
crosscheck-mitsuba-shared = pixelů, kde jsou povrchy dvou tvarů na jednom místě, takže je náhoda, který z nich je vidět: { $pixels }; jsou to { $pairs }
crosscheck-mitsuba-differences = pixelů: { $pixels }; polohy se liší nejvýše o { $distance }, to je { $share } přípustné odchylky; normály nejvýše o { $angle }°
crosscheck-how-povray = příkazem `apt-get install povray` nebo `brew install povray`, nebo z https://www.povray.org
crosscheck-how-mitsuba = příkazem `pip install mitsuba numpy`; tento Python pak zadejte volbou --program

## Typy záznamů: zpg explain, referenční příručka, editory

record-defines = Definuje { $kind }.
record-changes = Mění { $kinds }.
record-defines-or-changes = S novým ID definuje { $kind }; s ID { $kinds } mění to, co toto ID označuje.
record-number = číslo
record-integer = celé číslo
record-count = celé číslo, počet
record-id = ID { $kinds }
record-id-or-none = ID { $kinds }, nebo 0 pro žádnou
record-file-name = jméno souboru
record-scene-units = jednotky scény
record-degrees = stupně
record-share = podíl
record-not-zero = různé od 0
record-between = > { $low } a < { $high }
record-within = { $low } až { $high }
record-axis = 1, 2 nebo 3
default-black = černá
default-white = bílá
record-default = výchozí { $number }
record-page = { $family-capital }; anglické jméno `{ $keyword }`. { $effect }
record-parameters = Parametry
record-example = Příklad
record-repeated = pak N-krát:
record-repeated-again = pak znovu N-krát:
record-optional = pak buď všechny tyto, nebo žádný, na posledním řádku záznamu:

## Editory

hint-row = řádek { $row }:
hint-profile = bodů, poloměr ≤ { $radius }, y { $low } až { $high }
hint-profile-doc = rozsah profilu
hover-values-more = a dalších { $more }
hover-parameter = { $rule }, číslo { $number } z { $count }: { $type }
hover-undefined = { $id } není definováno
hover-line = (řádek { $line })
hover-colour = Barva { $colour }, zobrazí se jako `{ $shown }`
hover-uses = { $uses ->
    [0] Nepoužito
    [one] Použito jednou
   *[other] Použito { $uses }×
}, { $changes ->
    [0] nezměněno
    [one] změněno jednou
   *[other] změněno { $changes }×
}
hover-bounds = Meze: { $x }, { $y }, { $z }
hover-bounds-empty = Meze: prázdné
hover-side = { $axis } { $low } až { $high }

## zpg farm

farm-next = Jak ji spustit, říká { $path }.
farm-summary =
    Dílčích úloh: { $tasks }. Každá potrvá asi { $each } (procesorů: { $cores }), všechny dohromady { $all } výpočtu. { $tiles ->
        [one] Dílčí úlohou je obrázek.
       *[other] Dílčí úlohou je jeden z pásů obrázku (počet: { $tiles }).
    } Čtení a příprava scény zabere v každé úloze { $build }.{ $chunk ->
        [one] { "" }
       *[other] { " " }Najednou se kreslí úloh: { $chunk }.
    }

## zpg samotné

start =
    zpg: nástroje pro scény v jazyce ZPG

      zpg new scena.zpg      zapíše scénu, se kterou lze začít
      zpg check scena.zpg    řekne, co je špatně a co napsat místo toho
      zpg fmt scena.zpg      dá každý záznam na vlastní řádek a zarovná čísla
      zpg render scena.zpg   vykreslí scénu do souboru scena.png
      zpg explain koule      popíše typ záznamu nebo nález

    `zpg --help` vypíše všechny příkazy, `zpg render --help` všechny volby jednoho.
